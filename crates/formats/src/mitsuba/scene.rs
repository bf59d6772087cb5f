//! Scenes: shapes, a camera, and what else is at the top.

use radiosity_photometry::error::Refusal;
use radiosity_photometry::text::short;

use super::colours::Colours;
use super::element::Element;
use super::emitters;
use super::ids::Ids;
use super::leftovers;
use super::sensor;
use super::shapes::Shapes;
use crate::model::Model;
use radiosity_photometry::files::Files;

/// The model of a scene.
///
/// # Errors
/// A root that is no scene, no shapes, and whatever cannot be followed.
pub(super) fn model(root: &Element, files: &dyn Files) -> Result<Model, Refusal> {
    if root.tag != "scene" {
        return Err(root.refusal(
            format!("the file begins with <{}>, not with <scene>", short(&root.tag)),
            "name its format, or put it into <scene version=\"3.0.0\">",
        ));
    }
    let ids = Ids::of(root)?;
    let mut shapes = Shapes::new(&ids, files);
    let mut camera = None;
    for child in &root.children {
        match child.tag.as_str() {
            "shape" => shapes.add(child)?,
            "emitter" => emitters::left_out(child, &mut Colours { ids: &ids, remarks: &mut shapes.remarks }),
            "sensor" if camera.is_some() => {
                child.pass_over();
                shapes.remarks.add("cameras after the first are left out", child);
            }
            "sensor" => camera = sensor::camera(child, &ids, &mut shapes.remarks)?,
            _ => {}
        }
    }
    leftovers::remark(root, &mut shapes.remarks);
    let remarks = std::mem::take(&mut shapes.remarks);
    let mut model = shapes.finish();
    if model.surfaces.is_empty() {
        let fault =
            Refusal::new("the scene holds no shapes that are known", "add shapes, or name its format");
        return Err(fault.in_file(&root.file));
    }
    model.camera = camera;
    model.notes.extend(remarks.0);
    Ok(model)
}
