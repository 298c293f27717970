package rasterlab.app.shell.labs;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import rasterlab.app.clip.ClipLabModel;
import rasterlab.app.clip.scene.ClipMode;
import rasterlab.app.coordinates.CoordinatesLabModel;
import rasterlab.app.coordinates.figure.CoordinatesMode;
import rasterlab.app.coordinates.list.Example;
import rasterlab.app.coordinates.stack.StackProgram;
import rasterlab.app.coordinates.view.ViewKind;
import rasterlab.app.line.trace.LineMode;
import rasterlab.app.opengl.state.Group;
import rasterlab.app.polygon.PolygonLabModel;
import rasterlab.app.polygon.figure.PolygonMode;
import rasterlab.app.spline.CurveForm;
import rasterlab.app.spline.SplineLabModel;
import rasterlab.app.spline.SplineMode;
import rasterlab.app.spline.curve.Sampling;
import rasterlab.contract.SplineEnds;

/** The states of the tabs besides those they open with. */
public final class LabStates {
    /** The other states of the tab of splines, each with texts of its own. */
    private static final List<Consumer<SplineLabModel>> OTHER_SPLINES =
            List.of(
                    model -> model.curve().chooseForm(CurveForm.PIECES),
                    model -> model.curve().compareWith("adaptive-naive"),
                    model -> model.curve().chooseForm(CurveForm.B_SPLINE),
                    model -> model.curve().sample(Sampling.equal(9)),
                    model -> model.curve().show(model.curve().hazards().get(4).input()),
                    model -> model.show(SplineMode.FUNCTION),
                    model -> model.function().chooseEnds(SplineEnds.slopes(-1.25, 3)),
                    model -> model.function().chooseMethod("monotone"),
                    model -> model.function().show(model.function().hazards().get(0).input()));

    /** The other states of the tab of coordinates, each with texts of its own. */
    private static final List<Consumer<CoordinatesLabModel>> OTHER_COORDINATES =
            List.of(
                    model -> model.views().goTo(model.views().last()),
                    model -> model.views().goTo(2),
                    model -> model.views().choose(ViewKind.SPHERICAL_LEFT),
                    model -> model.views().choose(ViewKind.LOOK_AT),
                    model -> model.show(CoordinatesMode.TRANSFORMATIONS),
                    model -> model.transformations().show(Example.AXIS),
                    model -> model.transformations().show(Example.PROJECTIVE),
                    model -> tried(model, "rotate-axis", "axis-along-x", "seven-steps-textbook"),
                    model -> tried(model, "transform", "beyond-float", "float"),
                    model -> model.show(CoordinatesMode.STACK),
                    model -> model.stack().show(StackProgram.LOADED),
                    model -> model.stack().goTo(1),
                    model -> model.show(CoordinatesMode.ROTATION),
                    model -> model.rotation().chooseMethod("buneman-textbook"),
                    model -> model.show(CoordinatesMode.MEETING));

    /** A state of a tab other than its first one, with texts of its own. */
    public record Other(String tab, String name, Consumer<LabModels> change) {}

    public static List<Other> others() {
        List<Other> others = othersByMode();
        others.add(
                new Other(
                        "visibility",
                        "everything",
                        models -> {
                            MadeLabs.visibility(models)
                                    .choose(
                                            choice ->
                                                    choice.comparing("globe", "newell", "z24")
                                                            .withDifference(true));
                            MadeLabs.visibility(models).watchSteps(true);
                        }));
        others.add(
                new Other("light", "colours", models -> MadeLabs.light(models).showColors(true)));
        others.add(
                new Other(
                        "visibility",
                        "rows",
                        m ->
                                MadeLabs.visibility(m)
                                        .rows()
                                        .show("depth-buffer", "drift-8192", "z16")));
        for (String topic : List.of("texture-mapping", "texture-filter"))
            others.add(
                    new Other("light", topic, models -> MadeLabs.light(models).rows().open(topic)));
        return others;
    }

    private static List<Other> othersByMode() {
        var others = new ArrayList<Other>();
        for (Consumer<SplineLabModel> each : OTHER_SPLINES)
            others.add(
                    new Other("spline", "curve", models -> each.accept(MadeLabs.spline(models))));
        for (Consumer<CoordinatesLabModel> each : OTHER_COORDINATES)
            others.add(
                    new Other(
                            "coordinates",
                            "",
                            models -> each.accept(MadeLabs.coordinates(models))));
        for (Group each : Group.values())
            others.add(
                    new Other(
                            "opengl",
                            each.name(),
                            models -> MadeLabs.opengl(models).touch(each.settings().get(0))));
        for (ClipMode each : ClipMode.values())
            others.add(new Other("clip", each.name(), m -> showComparison(MadeLabs.clip(m), each)));
        for (LineMode each : LineMode.values())
            others.add(new Other("line", each.name(), m -> MadeLabs.line(m).chooseMode(each)));
        for (PolygonMode each : PolygonMode.values())
            others.add(
                    new Other(
                            "polygon",
                            each.name(),
                            m -> showComparison(MadeLabs.polygon(m), each)));
        return others;
    }

    private LabStates() {}

    private static void tried(
            CoordinatesLabModel model, String topic, String hazard, String method) {
        model.transformations().show(topic, hazard, method);
    }

    /** Shows as many rows in the inspector as there can be. */
    private static void showComparison(ClipLabModel clip, ClipMode mode) {
        clip.chooseMode(mode);
        clip.compareWith(clip.state().choice().scene().method());
        clip.goTo(1);
    }

    private static void showComparison(PolygonLabModel polygon, PolygonMode mode) {
        polygon.chooseMode(mode);
        polygon.compareWith(polygon.state().choice().scene().method());
        polygon.goTo(1);
    }
}
