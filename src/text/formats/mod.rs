//! What programs print, one file a family; the engine that reads them is `text/record`.
//!
//! Adding a format is adding an entry here and its test in `tests/text/formats`: the words that mark it, the
//! fields it has, what they mean, in a comment an example line and where that is known from.

mod autopilots;
mod cameras;
mod devices;
mod engines;
mod files;
mod graphics;
mod plain;
mod robots;
mod ros;
mod scenes;
mod space;

use crate::text::record::format::Format;

pub(crate) use plain::PLAIN;

/// All formats, in the order in which they are asked.
pub(crate) const FORMATS: &[&[Format]] = &[
    ros::ROS,
    robots::ROBOTS,
    cameras::CAMERAS,
    scenes::SCENES,
    engines::ENGINES,
    graphics::GRAPHICS,
    autopilots::AUTOPILOTS,
    devices::DEVICES,
    space::SPACE,
    files::FILES,
];
