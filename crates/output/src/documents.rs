//! Documents for people: reports in HTML and Markdown, plans, and the viewer.

pub mod document;
pub mod viewer;
pub mod plan_page;
pub mod heat;
pub mod audit;
pub mod html;
pub mod markdown;
pub mod report_page;
