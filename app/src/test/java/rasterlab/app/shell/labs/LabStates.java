package rasterlab.app.shell.labs;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import rasterlab.app.clip.ClipLabModel;
import rasterlab.app.clip.ClipRoom;
import rasterlab.app.clip.scene.ClipMode;
import rasterlab.app.coordinates.CoordinatesLabModel;
import rasterlab.app.coordinates.CoordinatesRoom;
import rasterlab.app.coordinates.figure.CoordinatesMode;
import rasterlab.app.coordinates.list.Example;
import rasterlab.app.coordinates.stack.StackProgram;
import rasterlab.app.coordinates.view.ViewKind;
import rasterlab.app.light.panel.LightRoom;
import rasterlab.app.line.LineRoom;
import rasterlab.app.line.trace.LineMode;
import rasterlab.app.opengl.OpenGlRoom;
import rasterlab.app.opengl.state.Group;
import rasterlab.app.polygon.PolygonLabModel;
import rasterlab.app.polygon.PolygonRoom;
import rasterlab.app.polygon.figure.PolygonMode;
import rasterlab.app.spline.CurveForm;
import rasterlab.app.spline.SplineLabModel;
import rasterlab.app.spline.SplineMode;
import rasterlab.app.spline.SplineRoom;
import rasterlab.app.spline.curve.Sampling;
import rasterlab.app.visibility.VisibilityRoom;
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

    /** Another state of a tab, with texts of its own. */
    public record Other(String tab, String name, Consumer<LabModels> change) {}

    public static List<Other> others() {
        var others = new ArrayList<Other>();
        for (Consumer<SplineLabModel> each : OTHER_SPLINES)
            others.add(
                    new Other(
                            "spline", "curve", models -> each.accept(models.of(new SplineRoom()))));
        for (Consumer<CoordinatesLabModel> each : OTHER_COORDINATES)
            others.add(
                    new Other(
                            "coordinates",
                            "",
                            models -> each.accept(models.of(new CoordinatesRoom()))));
        for (Group each : Group.values())
            others.add(
                    new Other(
                            "opengl",
                            each.name(),
                            models -> models.of(new OpenGlRoom()).touch(each.settings().get(0))));
        for (ClipMode each : ClipMode.values())
            others.add(
                    new Other(
                            "clip", each.name(), m -> showComparison(m.of(new ClipRoom()), each)));
        for (LineMode each : LineMode.values())
            others.add(new Other("line", each.name(), m -> m.of(new LineRoom()).chooseMode(each)));
        for (PolygonMode each : PolygonMode.values())
            others.add(
                    new Other(
                            "polygon",
                            each.name(),
                            m -> showComparison(m.of(new PolygonRoom()), each)));
        others.add(
                new Other(
                        "visibility",
                        "everything",
                        models -> {
                            models.of(new VisibilityRoom())
                                    .choose(
                                            choice ->
                                                    choice.comparing("globe", "newell", "z24")
                                                            .withDifference(true));
                            models.of(new VisibilityRoom()).watchSteps(true);
                        }));
        others.add(
                new Other(
                        "light",
                        "colours",
                        models -> models.of(new LightRoom()).showColours(true)));
        others.add(
                new Other(
                        "visibility",
                        "rows",
                        m ->
                                m.of(new VisibilityRoom())
                                        .rows()
                                        .show("depth-buffer", "drift-8192", "z16")));
        for (String topic : List.of("texture-mapping", "texture-filter"))
            others.add(
                    new Other(
                            "light",
                            topic,
                            models -> models.of(new LightRoom()).rows().open(topic)));
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
