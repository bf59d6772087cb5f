//! `animate`: pictures and readings of frames.

use radiosity_test_support::folders::folder;
#[cfg(unix)]
use std::collections::BTreeMap;
use std::fs;
#[cfg(unix)]
use std::{
    path::Path,
    process::{Command, Stdio},
    thread::sleep,
    time::{Duration, SystemTime},
};

use crate::floor;
use crate::program::{done, refused};

const ROOM: &str = r#"
frames = 12
fps = 4
bands = ["grey"]
camera = { eye = [0.5, 0.05, 0.5], target = [0.5, 1, 0.4], fov = 70, width = 24, height = 16 }
materials.wall = { reflectance = 0.5 }
materials.lamp = { reflectance = 0, emission = 10 }
[[surfaces]]
name = "room"
material = "wall"
box = { origin = [0, 0, 0], size = [1, 1, 1], inward = true }
[[surfaces]]
name = "lamp"
material = "lamp"
parallelogram = { origin = [0.2, 0.4, 0.9], edge1 = [0, 0.2, 0], edge2 = [0.2, 0, 0] }
[[motion]]
surfaces = "lamp"
translate = { points = [[0, 0, 0], [0.3, 0, 0]] }
"#;

const POINTS: &str = "x,y,z,nx,ny,nz\n0.3,0.5,0,0,0,1\n0.8,0.5,0,0,0,1\n";

/// The rows of a CSV after the first, as numbers.
fn rows(csv: &str) -> Vec<Vec<f64>> {
    let row = |line: &str| line.split(',').map(|cell| cell.parse().expect("a number")).collect();
    csv.lines().skip(1).map(row).collect()
}

#[test]
fn lux_over_time_is_that_of_the_frames_alone() {
    let folder = folder(&[("room.toml", ROOM), ("points.csv", POINTS)]);
    let folder = folder.path();
    let [table, told] = done(folder, &["animate", "room.toml", "--probe", "points.csv"]);
    assert_eq!(table.lines().next(), Some("frame,point,x,y,z,nx,ny,nz,E_grey,error"));
    assert!(told.contains("12 frames in"), "{told}");
    let rows = rows(&table);
    assert_eq!(rows.len(), 24);
    for frame in [0, 7, 11] {
        let number = frame.to_string();
        let [alone, _] = done(folder, &["probe", "room.toml", "--frame", &number, "--points", "points.csv"]);
        for (point, line) in alone.lines().skip(1).enumerate() {
            let light: f64 = line.split(',').nth(6).expect("a column").parse().expect("a number");
            let row = &rows[2 * frame + point];
            assert_eq!(row[..2], [frame as f64, point as f64]);
            assert!((row[8] - light).abs() < 1e-3 * light, "{frame} {point}: {} {light}", row[8]);
        }
    }
    // The lamp goes from the first point to the second.
    assert!(rows[22][8] < rows[0][8] && rows[23][8] > rows[1][8]);
    assert!(!folder.join("room-0000.png").exists());
}

/// The lamp above that floor moves by 0.9 along x.
const MOTION: &str = r#"
[[motion]]
luminaires = "lamp"
translate = { points = [[0, 0, 0], [0.9, 0, 0]] }
"#;

/// Constants on the floor are off by up to a half of the light, which by the inverse square is 100 / r³. Of the frame
/// that is checked each reading tells at least what it is off by, of the others as much in the mean.
#[test]
fn readings_of_a_checked_frame_err_by_what_was_found() {
    let points: String =
        (0..12).map(|k| format!("{},{},0,0,0,1\n", -0.95 + 0.15 * f64::from(k), 0.3)).collect();
    let floor = format!("frames = 4\n{}{MOTION}", floor::BELOW_A_LAMP);
    let folder = folder(&[("floor.toml", floor), ("points.csv", points)]);
    let args = ["animate", "floor.toml", "--animation", "fresh", "--order", "0", "--read", "basis"];
    let [table, told] = done(folder.path(), &[&args[..], &["--probe", "points.csv"]].concat());
    let before = told.split(" checked at 12 readings").next().expect("a line");
    let judged: f64 = before.rsplit(' ').next().and_then(|word| word.parse().ok()).expect("a frame");
    assert!(told.contains("checked at 12 readings"), "{told}");
    let mut in_others = [0.0; 2];
    for row in rows(&table) {
        let (along, [light, error]) = (row[2] - 0.3 * row[0], [row[8], row[9]]);
        let off = (light - 100.0 * (1.0 + along * along + row[3] * row[3]).powf(-1.5)).abs();
        if row[0] == judged {
            assert!(off < 1.0 || error > 0.999 * off, "{row:?} is off by {off}");
        } else {
            in_others = [in_others[0] + off * off, in_others[1] + error * error];
        }
    }
    let ratio = (in_others[1] / in_others[0]).sqrt();
    assert!((0.7..2.0).contains(&ratio), "{ratio}");
}

#[test]
fn pictures_have_numbers_and_those_that_are_there_stay() {
    let folder = folder(&[("room.toml", ROOM), ("points.csv", POINTS)]);
    let folder = folder.path();
    let args = ["animate", "room.toml", "--frames", "2..4", "-o", "f-##.png", "--samples", "1"];
    done(folder, &args);
    let read = |name: &str| fs::read(folder.join(name)).expect("it was written");
    let all = ["f-02.png", "f-03.png", "f-04.png"].map(read);
    assert!(all[0] != all[2], "the light moves");
    assert!(!folder.join("f-01.png").exists() && !folder.join("f-05.png").exists());
    fs::write(folder.join("f-03.png"), "mine").expect("it can be written");
    fs::remove_file(folder.join("f-04.png")).expect("it is there");
    let resumed = [&args[..], &["--resume"]].concat();
    done(folder, &resumed);
    assert_eq!(read("f-03.png"), b"mine");
    assert!(read("f-04.png") == all[2], "the same exposure as before");
}

/// The files of a folder with their content and the time they were written.
#[cfg(unix)]
fn pictures(folder: &Path) -> BTreeMap<String, (Vec<u8>, SystemTime)> {
    let files = fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry"));
    let file = |entry: fs::DirEntry| {
        let name = entry.file_name().into_string().expect("text");
        let written = entry.metadata().and_then(|data| data.modified()).expect("it has a time");
        (name, (fs::read(entry.path()).expect("it can be read"), written))
    };
    files.map(file).filter(|(name, _)| !name.ends_with(".toml") && !name.ends_with(".csv")).collect()
}

#[test]
#[cfg(unix)]
fn ctrl_c_keeps_the_frames_that_are_finished_and_the_rest_is_made_later() {
    let [stopped, whole] = [(); 2].map(|()| folder(&[("room.toml", ROOM), ("points.csv", POINTS)]));
    let (stopped, whole) = (stopped.path(), whole.path());
    let args = [
        "animate",
        "room.toml",
        "--animation",
        "selective",
        "--order",
        "6",
        "-o",
        "f-##.png",
        "--samples",
        "1",
    ];
    let mut program = Command::new(env!("CARGO_BIN_EXE_radiosity"));
    let mut child = program.current_dir(stopped).args(args).stderr(Stdio::null()).spawn().expect("it runs");
    while !stopped.join("f-02.png").exists() {
        assert!(child.try_wait().expect("it can be asked").is_none(), "it is at work");
        sleep(Duration::from_millis(2));
    }
    let killed = Command::new("kill").args(["-INT", &child.id().to_string()]).status();
    assert!(killed.expect("there is such a command").success());
    assert_eq!(child.wait().expect("it ends").code(), Some(130));
    let before = pictures(stopped);
    assert!((3..12).contains(&before.len()), "{:?}", before.keys());
    assert!(before.keys().eq((0..before.len()).map(|k| format!("f-{k:02}.png")).collect::<Vec<_>>().iter()));
    done(stopped, &[&args[..], &["--resume"]].concat());
    done(whole, &args);
    let (resumed, undisturbed) = (pictures(stopped), pictures(whole));
    assert!(before.iter().all(|(name, file)| resumed[name] == *file), "finished frames stay as they are");
    assert_eq!(resumed.len(), 12);
    assert!(
        resumed.iter().all(|(name, (picture, _))| undisturbed[name].0 == *picture),
        "all are those of one run"
    );
}

#[test]
fn what_frames_keep_for_the_next_ones_is_a_part_of_their_memory() {
    let folder = folder(&[("room.toml", ROOM), ("points.csv", POINTS)]);
    let folder = folder.path();
    let args = |way: &'static str| {
        [
            "animate",
            "room.toml",
            "--frames",
            "0",
            "--animation",
            way,
            "--probe",
            "points.csv",
            "--memory",
            "11.4M",
        ]
    };
    refused(folder, &args("selective"), &["not enough memory", "--animation fresh", "help: "]);
    done(folder, &args("fresh"));
}

#[test]
fn the_errors_of_rays_and_of_transfers_are_told() {
    let folder = folder(&[("room.toml", ROOM), ("points.csv", POINTS)]);
    let folder = folder.path();
    let by_rays = ["--transport", "sampled", "--rays", "20000", "--read-by", "rays", "--probe", "points.csv"];
    let frames = ["animate", "room.toml", "--frames", "0..3", "--animation", "selective"];
    let [_, told] = done(folder, &[&frames[..], &by_rays].concat());
    for part in [
        " rays, ",
        " % of them traced anew",
        "rays leave an error of",
        "light gathered by rays: standard deviation",
    ] {
        assert!(told.contains(part), "{part:?} is missing in:\n{told}");
    }
    // A ring on the floor, which rules do not reach.
    let ring = "[[surfaces]]\nname = 'ring'\nmaterial = 'wall'\ntorus = { center = [0.6, 0.6, 0.1], axis = [0, 0, 1], major = 0.2, minor = 0.1 }";
    let (start, motion) = ROOM.split_once("[[motion]]").expect("it moves");
    fs::write(folder.join("ring.toml"), format!("{start}{ring}\n[[motion]]{motion}"))
        .expect("it can be written");
    let how = [
        "--order",
        "3",
        "--subdivide",
        "1",
        "--eps",
        "3e-3",
        "--transport",
        "exact",
        "--direct",
        "projected",
    ];
    let [_, alone] = done(folder, &[&["solve", "ring.toml", "--frame", "0"][..], &how].concat());
    let warned =
        alone.lines().find_map(|line| line.strip_prefix("warning: the transfers")).expect("a warning");
    let frame =
        ["animate", "ring.toml", "--frames", "0", "--read", "basis", "-o", "r-#.png", "--samples", "1"];
    let [_, told] = done(folder, &[&frame[..], &how].concat());
    assert!(told.contains(&format!("warning: at 1 of 1 moments the transfers{warned}")), "{told}");
}

#[test]
fn a_film_lasts_as_long_as_its_frames() {
    let folder = folder(&[("room.toml", ROOM), ("points.csv", POINTS)]);
    let folder = folder.path();
    done(folder, &["animate", "room.toml", "-o", "room.gif", "--samples", "1"]);
    let file = fs::File::open(folder.join("room.gif")).expect("it was written");
    let mut film = gif::DecodeOptions::new().read_info(file).expect("a GIF");
    assert_eq!([film.width(), film.height()], [24, 16]);
    let mut delays = Vec::new();
    while let Some(frame) = film.next_frame_info().expect("a frame") {
        delays.push(frame.delay);
    }
    // Four a second, in hundredths.
    assert_eq!(delays, [25; 12]);
}

#[test]
fn an_animated_png_holds_all_frames_and_their_time() {
    let folder = folder(&[("room.toml", ROOM), ("points.csv", POINTS)]);
    let folder = folder.path();
    let args = ["animate", "room.toml", "--frames", "2..4", "--samples", "1", "--exposure", "1", "-o"];
    done(folder, &[&args[..], &["room.apng"]].concat());
    done(folder, &[&args[..], &["room-#.png"]].concat());
    let open = |name: &str| {
        let file = std::io::BufReader::new(fs::File::open(folder.join(name)).expect("it was written"));
        png::Decoder::new(file).read_info().expect("a PNG")
    };
    let mut film = open("room.apng");
    assert_eq!(film.info().animation_control().map(|control| control.num_frames), Some(3));
    for number in 2..5 {
        let mut still = open(&format!("room-{number}.png"));
        let pixels = |from: &mut png::Reader<std::io::BufReader<fs::File>>| {
            let mut pixels = vec![0; from.output_buffer_size().expect("it is small")];
            from.next_frame(&mut pixels).expect("a frame");
            pixels
        };
        assert!(pixels(&mut film) == pixels(&mut still), "{number}");
        let control = film.info().frame_control().expect("a frame of a film");
        assert_eq!([control.delay_num, control.delay_den], [250, 1000], "four a second");
    }
}

/// Advice names the file that was typed, not the text that was made of it, and each command of it runs.
#[test]
fn a_still_scene_of_another_program_is_advised_by_its_file() {
    let spheres = "void glow g 0 0 4 1 1 1 0\ng sphere lamp 0 0 4 5 0 0 1\nvoid plastic w 0 0 5 .5 .5 .5 0 0\n\
                   w sphere s 0 0 4 0 0 0 1\n";
    let folder = folder(&[("em.rad", spheres)]);
    let cure = "help: make it a scene, radiosity convert em.rad moving.toml, and add frames = 50 and [[motion]] to that, \
                docs/scene.md, or take one picture: radiosity render em.rad";
    refused(folder.path(), &["animate", "em.rad"], &["nothing moves", cure]);
    done(folder.path(), &["convert", "em.rad", "moving.toml"]);
    done(folder.path(), &["render", "em.rad", "-o", "em.png", "--size", "8x8"]);
}

#[test]
fn what_cannot_be_animated_is_refused_with_a_cure() {
    let folder = folder(&[("room.toml", ROOM), ("points.csv", POINTS)]);
    let folder = folder.path();
    let refuse = |args: &[&str], parts: &[&str]| {
        refused(folder, &[&["animate", "room.toml"][..], args].concat(), parts);
    };
    refused(folder, &["animate", "cornell-box"], &["nothing moves", "help: "]);
    refuse(&["--frames", "3..12"], &["12", "11"]);
    refuse(&["--frames", "5..3"], &["frame 5 comes after frame 3", "write 3..5"]);
    refuse(&["--frames", "5-3"], &["0..99"]);
    refuse(&["-o", "all.png"], &["one name for all frames", "frame-####.png"]);
    refuse(&["-o", "film.avi"], &["names no kind of pictures", ".gif, .apng"]);
    refuse(&["-o", "no/f-#.png"], &["its folder does not exist"]);
    refuse(&["-o", "f.gif", "--fps", "100"], &["50 pictures a second", "--fps 50"]);
    refuse(&["-o", "f.gif", "--fps", "0.0015"], &["655.35 s", "raise --fps"]);
    refuse(&["-o", "f.apng", "--fps", "0.01"], &["65.535 s", "raise --fps"]);
    refuse(&["-o", "f.apng", "--fps", "5000"], &["1000 pictures a second", "--fps 50"]);
    refuse(&["-o", "f-#.png", "--fps", "10"], &["files have no speed"]);
    refuse(&["-o", "f-#.exr", "--exposure", "1"], &["--exposure", "leave it out"]);
    refuse(&["--accuracy", "1e-2"], &["--accuracy", "--quality"]);
    refuse(&["--method", "hierarchical"], &["links of one frame", "solve --frame"]);
    refuse(&["--path-eps", "0"], &["above 0"]);
    refuse(&["--animation", "series", "--transport", "sampled"], &["rays carry", "--transport exact"]);
    let left = fs::read_dir(folder).expect("a folder").count();
    assert_eq!(left, 2, "nothing was written");
}

#[test]
fn what_passes_through_another_is_told_before_the_frames_are_made() {
    // The right edge of the lamp moves from 0.4 to 0.7, by 0.3/11 a frame: it reaches the gate after frame 5,
    // and the blade, which is no higher than the lamp is, in none.
    let things = "[[surfaces]]\nname = \"gate\"\nmaterial = \"wall\"\ntwo_sided = true\n\
                  parallelogram = { origin = [0.55,0.3,0.8], edge1 = [0,0.4,0], edge2 = [0,0,0.15] }\n\
                  [[surfaces]]\nname = \"blade\"\nmaterial = \"wall\"\ntwo_sided = true\n\
                  parallelogram = { origin = [0.6,0.3,0.6], edge1 = [0,0.4,0], edge2 = [0,0,0.2] }\n";
    let room = ROOM.replace("[[motion]]", &format!("{things}[[motion]]"));
    let folder = folder(&[("room.toml", room.as_str()), ("points.csv", POINTS)]);
    let animate = ["animate", "room.toml", "--probe", "points.csv", "--order", "0"];
    let told = |more: &[&str]| done(folder.path(), &[&animate[..], more].concat())[1].clone();
    let all = told(&[]);
    let warned =
        "warning: surface \"lamp\" passes through \"gate\" in frames 6 to 11: lead its path past that\n";
    assert!(all.starts_with(warned) && all.matches("warning").count() == 1, "{all}");
    assert!(!told(&["--frames", "0..4"]).contains("warning"));
    assert!(told(&["--frames", "5..6"]).contains("passes through \"gate\" in frame 6"));
    assert!(told(&["-q"]).is_empty());
}

#[test]
fn series_tell_their_error_and_when_they_are_repaid() {
    let folder = folder(&[("room.toml", ROOM), ("points.csv", POINTS)]);
    let animate = ["animate", "room.toml", "--probe", "points.csv", "--transport", "exact", "--order", "3"];
    let told = |more: &[&str]| done(folder.path(), &[&animate[..], more].concat());
    let [table, line] = told(&["--animation", "series"]);
    assert!(line.contains("known to ") && line.contains("set-up "), "{line}");
    let [fresh, line] = told(&["--animation", "fresh"]);
    assert!(!line.contains("set-up"), "{line}");
    for (own, right) in rows(&table).iter().zip(rows(&fresh)) {
        assert!((own[8] - right[8]).abs() < 1e-3 * right[8], "{own:?} {right:?}");
    }
}

/// Films by a program in the place of ffmpeg.
#[cfg(unix)]
mod films {
    use std::ffi::OsString;
    use std::os::unix::fs::PermissionsExt;
    use std::path::Path;
    use std::process::{Command, Output, Stdio};
    use std::{fs, thread, time::Duration};

    use radiosity_test_support::folders::{folder, names};

    use crate::program::command;

    const FILM: [&str; 9] =
        ["animate", "room.toml", "--frames", "2..4", "--size", "23x15", "--samples", "1", "-o"];

    /// A folder `bin` with a program of this name and text.
    fn stand_in(folder: &Path, script: &str) -> OsString {
        let bin = folder.join("bin");
        fs::create_dir_all(&bin).expect("a folder");
        let program = bin.join("ffmpeg");
        fs::write(&program, format!("#!/bin/sh\n[ \"$1\" = -version ] && exit 0\n{script}\n"))
            .expect("a file");
        fs::set_permissions(&program, fs::Permissions::from_mode(0o755)).expect("its mode");
        let mut path = bin.into_os_string();
        path.push(":/usr/bin:/bin");
        path
    }

    fn film(folder: &Path, path: &OsString, name: &str) -> Output {
        command(folder, &[&FILM[..], &[name]].concat()).env("PATH", path).output().expect("it runs")
    }

    const KEEPS: &str =
        r#"cat > "$0.pixels"; echo "$@" > "$0.arguments"; for last; do :; done; echo film > "$last""#;

    #[test]
    fn pictures_go_through_a_pipe_and_the_film_takes_its_name_at_the_end() {
        let folder = folder(&[("room.toml", super::ROOM), ("points.csv", super::POINTS)]);
        let folder = folder.path();
        let path = stand_in(folder, KEEPS);
        for (name, kind) in [("light.mp4", "-f mp4"), ("light.webm", "-f webm")] {
            let output = film(folder, &path, name);
            assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
            assert_eq!(fs::read(folder.join(name)).expect("the film"), b"film\n");
            let arguments = fs::read_to_string(folder.join("bin/ffmpeg.arguments")).expect("it was called");
            for part in
                ["-video_size 24x16", "-framerate 4 ", "-pix_fmt yuv420p", "-pixel_format rgb24", kind]
            {
                assert!(arguments.contains(part), "{part:?} is missing in {arguments}");
            }
            let pixels = fs::read(folder.join("bin/ffmpeg.pixels")).expect("the pictures");
            assert_eq!(pixels.len(), 3 * 24 * 16 * 3);
            let pictures: Vec<&[u8]> = pixels.chunks(24 * 16 * 3).collect();
            assert!(pictures[0] != pictures[2], "the light moves");
            // Odd sizes: the last column and row twice.
            let row = |k: usize| &pictures[0][k * 72..(k + 1) * 72];
            assert_eq!(row(14), row(15));
            assert!((0..16).all(|k| row(k)[66..69] == row(k)[69..72]));
        }
        assert_eq!(names(folder), ["bin", "light.mp4", "light.webm", "points.csv", "room.toml"]);
    }

    #[test]
    fn a_program_that_fails_leaves_the_old_film() {
        let folder = folder(&[("room.toml", super::ROOM), ("points.csv", super::POINTS)]);
        let folder = folder.path();
        fs::write(folder.join("light.mp4"), "old").expect("it can be written");
        for script in ["cat > /dev/null; echo no such codec >&2; exit 3", "echo no such codec >&2; exit 3"] {
            let output = film(folder, &stand_in(folder, script), "light.mp4");
            let said = String::from_utf8_lossy(&output.stderr);
            assert_eq!(output.status.code(), Some(1), "{said}");
            assert!(said.contains("no such codec") && said.contains("light.mp4"), "{said}");
            assert_eq!(fs::read(folder.join("light.mp4")).expect("it is there"), b"old");
            assert_eq!(names(folder), ["bin", "light.mp4", "points.csv", "room.toml"]);
        }
    }

    #[test]
    fn without_the_program_the_cure_is_told_before_any_work() {
        let folder = folder(&[("room.toml", super::ROOM), ("points.csv", super::POINTS)]);
        let folder = folder.path();
        let output = film(folder, &folder.join("none").into_os_string(), "light.mp4");
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{said}");
        for part in ["light.mp4", "ffmpeg", "not found", "apt install ffmpeg", ".gif", "frame-####.png"] {
            assert!(said.contains(part), "{part:?} is missing in {said}");
        }
        assert_eq!(names(folder), ["points.csv", "room.toml"]);
    }

    #[test]
    fn ctrl_c_leaves_nothing_and_ends_the_program_too() {
        let folder = folder(&[("room.toml", super::ROOM), ("points.csv", super::POINTS)]);
        let folder = folder.path();
        let path = stand_in(folder, r#"echo $$ > "$0.begun"; exec sleep 100"#);
        let mut command = command(folder, &[&FILM[..], &["light.mp4"]].concat());
        let mut run = command.env("PATH", path).stderr(Stdio::null()).spawn().expect("it runs");
        let begun = folder.join("bin/ffmpeg.begun");
        let number = || fs::read_to_string(&begun).ok().filter(|number| number.ends_with('\n'));
        while number().is_none() {
            thread::sleep(Duration::from_millis(5));
        }
        let signal = |signal: &str, number: &str| {
            let mut kill = Command::new("kill");
            kill.args([signal, number]).stderr(Stdio::null()).status().expect("it runs").success()
        };
        assert!(signal("-INT", &run.id().to_string()));
        assert_eq!(run.wait().expect("it ends").code(), Some(130));
        // Who has lost its parent ends a moment later.
        let goes_on = || signal("-0", number().expect("it is there").trim());
        let tries = (0..1000).take_while(|_| goes_on()).map(|_| thread::sleep(Duration::from_millis(5)));
        assert!(tries.count() < 1000, "the program goes on");
        assert_eq!(names(folder), ["bin", "points.csv", "room.toml"]);
    }
}
