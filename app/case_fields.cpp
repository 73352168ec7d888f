// The keys of the case file: name, unit, range, default and meaning of each.
#include "app/case.hpp"

namespace ostium::app {
namespace {

std::string check_opening(const OpeningCase& o) {
  const int given = o.largest.has_value() + o.edge.has_value() + o.nearest.has_value() + o.label.has_value();
  return given == 1 ? ""
                    : "an opening is chosen by exactly one of \"largest\", \"nearest\", \"label\" and (2D) "
                      "\"edge\"; "
                      "write for example {largest: 1}";
}

std::string check_vessel(const VesselCase& v) {
  if (v.dimension == 3 && (!v.surface || v.outline))
    return "a vessel in 3D has a \"surface\" and no \"outline\"";
  if (v.dimension == 2 && (v.surface || !v.outline))
    return "a vessel in 2D has an \"outline\" and no \"surface\"";
  if (v.dimension == 3 && !v.length_unit)
    return "the key \"length_unit\" is missing: surface files carry no unit; add for example \"length_unit: "
           "mm\"";
  for (const auto& [name, o] : v.openings)
    if (o.edge && v.dimension == 3)
      return "the opening \"" + name + "\" is chosen by \"edge\", which is for 2D outlines";
  return {};
}

std::string check_time(const TimeCase& t) {
  if (t.end && t.cycles) return "give either \"end\" or \"cycles\" (with \"period\"), not both";
  if (!t.end && !t.period)
    return "the length of the run is missing; add \"period\" and \"cycles\", or \"end\"";
  return {};
}

}  // namespace

void declare(config::Fields<OpeningCase>& f) {
  f.integer("largest", &OpeningCase::largest, "rank by area, 1 is the largest").at_least(1);
  f.list("nearest", &OpeningCase::nearest, "m", "the opening whose centre is nearest to this point");
  f.text("label", &OpeningCase::label, "face id or face name of the surface file");
  f.integer("edge", &OpeningCase::edge,
            "2D: number of the edge of the outline, from 0; it begins at the corner of that number")
      .at_least(0);
  f.choice("profile", &OpeningCase::profile,
           {{"parabolic", sph3d::Profile::parabolic}, {"plug", sph3d::Profile::plug}},
           "where the network prescribes the flow: developed laminar flow for any outline, or the same "
           "velocity everywhere")
      .or_else(sph3d::Profile::parabolic);
  f.origin(&OpeningCase::origin);
  f.check(check_opening);
}

void declare(config::Fields<VesselCase>& f) {
  f.integer("dimension", &VesselCase::dimension, "2 or 3; in 2D flows are per metre of depth")
      .at_least(2)
      .at_most(3)
      .or_else(3);
  f.path("surface", &VesselCase::surface, "3D: STL or VTP file of the vessel's closed surface");
  f.raw("outline", &VesselCase::outline,
        "2D: corners of the outline, `[[0 mm, 0 mm], [20 mm, 0 mm], ..]`, or a CSV file of their x and y in "
        "`length_unit`");
  f.unit("length_unit", &VesselCase::length_unit, "m",
         "unit of the coordinates in the file, which carries none");
  f.quantity("spacing", &VesselCase::spacing, "m", "particle spacing dp").positive();
  f.flag("cap_open_ends", &VesselCase::cap_open_ends,
         "close open ends of the surface with flat caps and take these as openings")
      .or_else(false);
  f.map("openings", &VesselCase::openings,
        "the openings by the names they have in the network; without it opening1, opening2, ... by falling "
        "area")
      .or_else({});
  f.section("wall", &VesselCase::wall, "the wall of the vessel");
  f.origin(&VesselCase::origin);
  f.check(check_vessel);
}

void declare(config::Fields<FluidCase>& f) {
  f.quantity("density", &FluidCase::density, "kg/m3", "density of blood").positive().or_else(1060);
  f.quantity("viscosity", &FluidCase::viscosity, "Pa.s", "dynamic viscosity, Newtonian")
      .positive()
      .or_else(0.004);
  f.quantity(
       "sound_speed", &FluidCase::sound_speed, "m/s",
       "artificial speed of sound; without it chosen from the largest velocity and pressure to be expected")
      .positive();
  f.origin(&FluidCase::origin);
}

void declare(config::Fields<NetworkCase>& f) {
  f.raw("blocks", &NetworkCase::blocks, "the elements of the network by name, see the page of the blocks");
  f.raw(
      "subnetworks", &NetworkCase::subnetworks,
      "parts of the network defined once and used as blocks by their names, see the page of the subnetworks");
  f.choice("initial", &NetworkCase::initial,
           {{"periodic", network::Initial::periodic}, {"rest", network::Initial::rest}},
           "start from the periodic state of the network or from rest; without it periodic where "
           "`time.period` is given");
  f.flag("periodic", &NetworkCase::periodic,
         "true: the same as `initial: periodic`, false: as `initial: rest`");
  f.check([](const NetworkCase& n) -> std::string {
    if (!n.initial || !n.periodic) return {};
    return "give either \"initial\" or \"periodic\", not both: they say the same";
  });
}

void declare(config::Fields<CouplingCase>& f) {
  f.choice("scheme", &CouplingCase::scheme,
           {{"linearised", Scheme::linearised},
            {"held", Scheme::held},
            {"extrapolated", Scheme::extrapolated},
            {"modified_euler", Scheme::modified_euler}},
           "what an opening assumes of the network's pressure until the next exchange")
      .or_else(Scheme::linearised);
  f.quantity("exchange", &CouplingCase::exchange, "s",
             "time between two exchanges; without it after every advection step")
      .positive();
  f.quantity(
       "filter_time", &CouplingCase::filter_time, "s",
       "time constant that separates the fast part of an opening's flow; without it chosen from the step")
      .positive();
  f.quantity(
       "datum_time", &CouplingCase::datum_time, "s",
       "time constant of the moving pressure datum, which keeps the fluid's artificial compressibility from "
       "storing blood; 0 turns it off, without it chosen from the vessel")
      .non_negative();
  f.flag("force", &CouplingCase::force, "run even where the stability numbers forbid it").or_else(false);
}

void declare(config::Fields<TimeCase>& f) {
  f.quantity("period", &TimeCase::period, "s", "period of the heart beat").at_least(1e-6).at_most(1e6);
  f.integer("cycles", &TimeCase::cycles, "number of periods to run; 1 if only the period is given")
      .at_least(1)
      .at_most(1000000);
  f.quantity("end", &TimeCase::end, "s", "end of the run, instead of cycles").at_least(1e-6).at_most(1e9);
  f.check(check_time);
}

void declare(config::Fields<SvzerodCase>& f) {
  f.choice("cycles", &SvzerodCase::all_cycles, {{"last", false}, {"all", true}},
           "all cycles, or the last one with its times from 0; without `time.period` all")
      .or_else(false);
  f.flag("mean_only", &SvzerodCase::mean_only, "one row per name, the mean of its values").or_else(false);
  f.raw("variables", &SvzerodCase::variables,
        "names of the rows: `NAME: [unit, series, -1 * series, ..]`, a sum of series of network.csv; without "
        "it all "
        "series in SI");
  f.raw("start", &SvzerodCase::start,
        "`NAME: value`: the first row holds these values instead, 0 for other names, because svZeroDSolver "
        "writes the "
        "start as its file gives it; network.csv has the consistent one");
}

void declare(config::Fields<ProbeCase>& f) {
  f.list("at", &ProbeCase::at, "m", "the place: three coordinates, in 2D two");
  f.choice("on", &ProbeCase::on_wall, {{"blood", false}, {"wall", true}},
           "stay there in the blood, or follow the point of the wall that is nearest to it at the start, at "
           "most two spacings away")
      .or_else(false);
  f.origin(&ProbeCase::origin);
}

void declare(config::Fields<OutputCase>& f) {
  f.quantity("every", &OutputCase::every, "s", "interval between two rows of the series")
      .positive()
      .or_else(0.01);
  f.quantity("from", &OutputCase::from, "s", "the series have no rows before this time")
      .non_negative()
      .or_else(0);
  f.quantity("fields_every", &OutputCase::fields_every, "s",
             "interval between two sets of fields for ParaView; 0: none, without it a tenth of the period")
      .non_negative();
  f.quantity(
       "checkpoint_every", &OutputCase::checkpoint_every, "s",
       "with a vessel: wall time between two checkpoints, from which `ostium run --resume` goes on; 0: only "
       "when the run is interrupted or its numerics fail")
      .non_negative()
      .or_else(900);
  f.map("probes", &OutputCase::probes,
        "with a vessel: points to be watched, by names of your choice, in probes.csv: "
        "`{jet: {at: [10 mm, 5 mm, 0 mm]}}`")
      .or_else({});
  f.section("svzerod", &OutputCase::svzerod,
            "what `ostium run --format svzerod` writes to svzerod.csv, in the layout of svZeroDSolver");
}

void declare(config::Fields<NumericsCase>& f) {
  f.number("advection_cfl", &NumericsCase::advection_cfl,
           "share of the smoothing length a particle may move in an advection step")
      .positive()
      .at_most(0.5)
      .or_else(0.25);
  f.number("acoustic_cfl", &NumericsCase::acoustic_cfl,
           "share of the smoothing length sound may travel in an acoustic step")
      .positive()
      .at_most(1)
      .or_else(0.6);
  f.number("shift", &NumericsCase::shift, "strength of the transport shift").non_negative().or_else(0.2);
  f.number("limiter", &NumericsCase::limiter, "limiter of the pressure dissipation").positive().or_else(3);
  f.number("density_relaxation", &NumericsCase::density_relaxation,
           "share of the summed density in each re-initialisation")
      .at_least(0)
      .at_most(1)
      .or_else(0.2);
  f.quantity("reference_speed", &NumericsCase::reference_speed, "m/s",
             "velocity that bounds the advection step from above; without it chosen from the inflow")
      .positive();
}

void declare(config::Fields<Case>& f) {
  f.text("title", &Case::title, "one line for reports").or_else("");
  f.section("vessel", &Case::vessel, "the vessel in 2D or 3D; without it the network runs alone");
  f.section("fluid", &Case::fluid, "the blood");
  f.section("network", &Case::network, "the circulation beyond the openings");
  f.section("coupling", &Case::coupling, "how vessel and network talk to each other");
  f.section("time", &Case::time, "how long to run").required();
  f.section("output", &Case::output, "what is written");
  f.section("numerics", &Case::numerics, "advanced: numbers of the methods");
  f.section("sensitivities", &Case::sensitivities,
            "without a vessel: how results over the last period depend on parameters, in sensitivities.csv");
  f.section("calibration", &Case::calibration,
            "without a vessel: targets and free parameters of `ostium calibrate`");
  f.section("sweep", &Case::sweep, "without a vessel: samples of parameters and results of `ostium sweep`");
  f.origin(&Case::origin);
}

}  // namespace ostium::app
