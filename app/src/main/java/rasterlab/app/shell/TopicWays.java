package rasterlab.app.shell;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import rasterlab.app.canvas.History;
import rasterlab.app.clip.ClipLabModel;
import rasterlab.app.clip.ClipMode;
import rasterlab.app.coordinates.CoordinatesLabModel;
import rasterlab.app.coordinates.figure.CoordinatesMode;
import rasterlab.app.light.LightLabModel;
import rasterlab.app.line.LineLabModel;
import rasterlab.app.line.LineMode;
import rasterlab.app.polygon.PolygonLabModel;
import rasterlab.app.polygon.PolygonMode;
import rasterlab.app.row.RowLabModel;
import rasterlab.app.spline.SplineLabModel;
import rasterlab.app.spline.SplineMode;
import rasterlab.app.visibility.TopicView;
import rasterlab.app.visibility.VisibilityLabModel;
import rasterlab.engine.circle.Circle;
import rasterlab.engine.circle.Ellipse;
import rasterlab.engine.geometry.meeting.PlaneAndLines;
import rasterlab.engine.line.Segment;
import rasterlab.engine.spline.CurveTask;
import rasterlab.engine.spline.SplineProblem;
import rasterlab.engine.transform.matrix.MatrixCall;
import rasterlab.engine.transform.rotate.Turns;
import rasterlab.engine.visibility.faces.Body;
import rasterlab.engine.visibility.hidden.SurfaceView;
import rasterlab.engine.visibility.order.Sight;

/** The way of each topic into its tab. A further topic is one more line. */
final class TopicWays {
    /** Methods of the other topics about hidden surfaces, by what draws by them. */
    private static final Map<String, String> DRAWN_BY =
            Map.of(
                    "mean-z-textbook", "painter-textbook",
                    "mean-z", "painter",
                    "convex-segment-textbook", "convex",
                    "convex-segment", "convex");

    /** Topics about light, and by which of their methods the lab draws. */
    private static final Map<String, Set<String>> LIT =
            Map.of(
                    "shade", Set.of("phong", "blinn-phong"),
                    "shade-face", Set.of("flat", "gouraud", "phong"),
                    "vertex-normals", Set.of("plain-textbook", "plain", "area", "angle"),
                    "color", Set.of("formula"));

    private final Map<String, TopicWay> ways = new TreeMap<>();

    TopicWays(LabModels models) {
        lines(models.line());
        polygons(models.polygon());
        clipping(models.clip());
        coordinates(models.coordinates());
        visibility(models.visibility());
        light(models.light());
        splines(models.spline());
        rows("visibility", models.visibility().rows());
        rows("light", models.light().rows());
    }

    /** The way of that topic; empty where there is none. */
    Optional<TopicWay> of(String topic) {
        return Optional.ofNullable(ways.get(topic));
    }

    private void lines(LineLabModel lab) {
        put(
                "line",
                "line",
                lab.history(),
                input -> {
                    lab.chooseMode(LineMode.SEGMENT);
                    lab.show((Segment) input);
                },
                lab::chooseMethod);
        put(
                "circle",
                "line",
                lab.figures().history(),
                input -> {
                    lab.chooseMode(LineMode.CIRCLE);
                    lab.figures().show((Circle) input);
                },
                lab.figures()::chooseMethod);
        put(
                "ellipse",
                "line",
                lab.figures().history(),
                input -> {
                    lab.chooseMode(LineMode.ELLIPSE);
                    lab.figures().show((Ellipse) input);
                },
                lab.figures()::chooseMethod);
    }

    private void polygons(PolygonLabModel lab) {
        for (PolygonMode mode : PolygonMode.values())
            put(
                    mode.topic(),
                    "polygon",
                    lab.history(),
                    input -> lab.showInput(mode, input),
                    lab::chooseMethod);
    }

    private void clipping(ClipLabModel lab) {
        for (ClipMode mode : ClipMode.values())
            put(
                    mode.topic(),
                    "clip",
                    lab.history(),
                    input -> lab.showInput(mode, input),
                    lab::chooseMethod);
    }

    private void splines(SplineLabModel lab) {
        put(
                "curve",
                "spline",
                lab.curve().history(),
                input -> {
                    lab.show(SplineMode.CURVE);
                    lab.curve().show((CurveTask) input);
                },
                lab.curve()::chooseMethod);
        put(
                "spline-function",
                "spline",
                lab.function().history(),
                input -> {
                    lab.show(SplineMode.FUNCTION);
                    lab.function().show((SplineProblem) input);
                },
                lab.function()::chooseMethod);
    }

    private void coordinates(CoordinatesLabModel lab) {
        put(
                "rotate",
                "coordinates",
                lab.rotation().history(),
                input -> {
                    lab.show(CoordinatesMode.ROTATION);
                    lab.rotation().show((Turns) input);
                },
                lab.rotation()::chooseMethod);
        put(
                "matrix",
                "coordinates",
                lab.transformations().history(),
                input -> {
                    lab.show(CoordinatesMode.TRANSFORMATIONS);
                    lab.transformations().show((MatrixCall) input);
                },
                lab.transformations()::chooseMethod);
        put(
                "line-plane",
                "coordinates",
                lab.meeting().history(),
                input -> {
                    lab.show(CoordinatesMode.MEETING);
                    lab.meeting().show((PlaneAndLines) input);
                },
                lab.meeting()::chooseMethod);
        for (String topic : List.of("transform", "view", "rotate-axis")) points(topic, lab);
    }

    /** Points of space, beside what the method makes of them. */
    private void points(String topic, CoordinatesLabModel lab) {
        ways.put(
                topic,
                TopicWay.whole(
                        "coordinates",
                        (input, method) -> {
                            lab.show(CoordinatesMode.TRANSFORMATIONS);
                            lab.transformations().show(topic, input.hazard(), method);
                        }));
    }

    private void visibility(VisibilityLabModel lab) {
        seen(
                "hidden-surfaces",
                lab,
                (in, method) -> TopicView.of(in.name(), (SurfaceView) in.input(), method));
        seen(
                "visible-faces",
                lab,
                (in, method) ->
                        TopicView.of(in.name(), (Body) in.input(), method, drawnBy(method)));
        seen(
                "depth-order",
                lab,
                (in, method) ->
                        TopicView.of(in.name(), (Sight) in.input(), method, drawnBy(method)));
    }

    private static String drawnBy(String method) {
        return DRAWN_BY.getOrDefault(method, method);
    }

    private void seen(
            String topic, VisibilityLabModel lab, BiFunction<TopicInput, String, TopicView> view) {
        ways.put(
                topic,
                new TopicWay(
                        "visibility",
                        (input, method) -> {
                            lab.rows().close();
                            lab.choose(view.apply(input, method)::shown);
                        },
                        Optional.of(
                                new TopicWay.Notes(
                                        (input, method) -> view.apply(input, method).unlike(),
                                        method -> true,
                                        lab::tell))));
    }

    private void rows(String tab, RowLabModel lab) {
        for (String topic : lab.topics())
            ways.put(
                    topic,
                    TopicWay.whole(
                            tab, (input, method) -> lab.show(topic, input.hazard(), method)));
    }

    private void light(LightLabModel lab) {
        for (String topic : LIT.keySet())
            ways.put(
                    topic,
                    new TopicWay(
                            "light",
                            (input, method) -> {
                                lab.rows().close();
                                lab.show(topic, input.hazard(), input.input(), method);
                            },
                            Optional.of(
                                    new TopicWay.Notes(
                                            (input, method) -> lab.unlike(input.input(), method),
                                            LIT.get(topic)::contains,
                                            lab::tell))));
    }

    /**
     * @param history of what is shown, for which input and method are one change
     */
    private void put(
            String topic,
            String tab,
            History<?> history,
            Consumer<Object> show,
            Consumer<String> chooseMethod) {
        ways.put(
                topic,
                TopicWay.whole(
                        tab,
                        (input, method) ->
                                history.asOne(
                                        () -> {
                                            show.accept(input.input());
                                            if (!method.isEmpty()) chooseMethod.accept(method);
                                        })));
    }
}
