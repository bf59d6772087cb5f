//! A canvas: a picture that plotters draws on, with anti-aliased lines and its own font.

use std::convert::Infallible;

use plotters_backend::text_anchor::{HPos, VPos};
use plotters_backend::{
    BackendColor, BackendCoord, BackendStyle, BackendTextStyle, DrawingBackend, DrawingErrorKind,
    FontTransform,
};

use super::lettering::Lettering;
use super::picture::Picture;

/// A picture to draw charts on.
#[derive(Debug)]
pub(crate) struct Canvas<'a> {
    picture: &'a mut Picture,
}

impl<'a> Canvas<'a> {
    /// Draws on `picture`.
    pub(crate) fn new(picture: &'a mut Picture) -> Self {
        Self { picture }
    }
}

type Drawn = Result<(), DrawingErrorKind<Infallible>>;

impl DrawingBackend for Canvas<'_> {
    type ErrorType = Infallible;

    fn get_size(&self) -> (u32, u32) {
        self.picture.size().into()
    }

    fn ensure_prepared(&mut self) -> Drawn {
        Ok(())
    }

    fn present(&mut self) -> Drawn {
        Ok(())
    }

    fn draw_pixel(&mut self, (x, y): BackendCoord, colour: BackendColor) -> Drawn {
        self.picture.blend(x, y, colour.rgb.into(), colour.alpha);
        Ok(())
    }

    fn draw_line<S: BackendStyle>(&mut self, from: BackendCoord, to: BackendCoord, style: &S) -> Drawn {
        let colour = style.color();
        let width = f64::from(style.stroke_width());
        self.picture.line(middle(from), middle(to), width, colour.rgb.into(), colour.alpha);
        Ok(())
    }

    fn draw_path<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        path: I,
        style: &S,
    ) -> Drawn {
        let path: Vec<BackendCoord> = path.into_iter().collect();
        path.windows(2).try_for_each(|ends| self.draw_line(ends[0], ends[1], style))
    }

    fn draw_circle<S: BackendStyle>(
        &mut self,
        center: BackendCoord,
        radius: u32,
        style: &S,
        fill: bool,
    ) -> Drawn {
        let (radius, half) = (f64::from(radius), 0.5 * f64::from(style.stroke_width()));
        let colour = style.color().rgb.into();
        if fill {
            self.picture.disk(middle(center), radius, colour);
        } else {
            self.picture.disk(middle(center), radius + half, colour);
            self.picture.disk(middle(center), radius - half, [255; 3]);
        }
        Ok(())
    }

    fn draw_text<S: BackendTextStyle>(&mut self, text: &str, style: &S, (x, y): BackendCoord) -> Drawn {
        let upright = matches!(style.transform(), FontTransform::Rotate90 | FontTransform::Rotate270);
        let text = Lettering { text, size: style.size() as u32, colour: style.color().rgb.into(), upright };
        let [width, height] = text.extent();
        let back = match style.anchor().h_pos {
            HPos::Left => 0,
            HPos::Center => width / 2,
            HPos::Right => width,
        };
        let up = match style.anchor().v_pos {
            VPos::Top => 0,
            VPos::Center => height / 2,
            VPos::Bottom => height,
        };
        text.draw(self.picture, if upright { [x - up, y + back] } else { [x - back, y - up] });
        Ok(())
    }

    fn estimate_text_size<S: BackendTextStyle>(
        &self,
        text: &str,
        style: &S,
    ) -> Result<(u32, u32), DrawingErrorKind<Infallible>> {
        let style =
            Lettering { text, size: style.size() as u32, colour: style.color().rgb.into(), upright: false };
        let [width, height] = style.extent();
        Ok((width as u32, height as u32))
    }
}

fn middle((x, y): BackendCoord) -> [f64; 2] {
    [f64::from(x) + 0.5, f64::from(y) + 0.5]
}
