% SPDX-License-Identifier: BSD-3-Clause
% results.m FOLDER: what a run with --mat leaves, read and drawn by Octave, as docs/tutorial.md says.
folder = argv(){1};
channels = load([folder "/channels.mat"]);
results = load([folder "/results.h5"], "channels", "field");

% The same numbers in both: the channels of channels.mat have the units of channels.csv, those of results.h5 SI.
surface = channels.surface_temperature;
assert(numel(surface) == numel(channels.time) && numel(surface) > 100);
assert(strcmp(strtrim(channels.unit(strcmp(cellstr(channels.variable), "surface_temperature"), :)), "degC"));
assert(results.channels.surface_temperature(:), surface(:) + 273.15, 1e-9);
assert(columns(results.field.temperature) == numel(results.field.time));

warning("off", "all");  % gnuplot is not the toolkit that Octave would take on a screen
graphics_toolkit("gnuplot");
picture = figure("visible", "off");
plot(channels.time, surface);
xlabel("s");
ylabel("degC");
print(picture, "-dsvg", [folder "/picture.svg"]);
assert(stat([folder "/picture.svg"]).size > 2000);
disp("read and drawn");
