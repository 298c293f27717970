package rasterlab.app.line.figure;

import java.util.List;
import java.util.Optional;
import rasterlab.app.line.trace.LineMode;
import rasterlab.app.mine.OwnMethods;
import rasterlab.engine.circle.ArcWalk;
import rasterlab.engine.circle.Circle;
import rasterlab.engine.circle.CircleTopic;
import rasterlab.engine.circle.Ellipse;
import rasterlab.engine.circle.EllipseTopic;
import rasterlab.engine.circle.SteppedCircle;
import rasterlab.engine.circle.SteppedEllipse;
import rasterlab.engine.line.LineTopic;
import rasterlab.engine.naming.Named;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;

/** The engine's topics behind the figures. */
public record FigureTopics(
        CircleTopic circle, EllipseTopic ellipse, LineTopic line, OwnMethods own) {
    FigureTopics() {
        this(new OwnMethods());
    }

    FigureTopics(OwnMethods own) {
        this(new CircleTopic(), new EllipseTopic(), new LineTopic(), own);
    }

    /** The topic of a mode; empty where the pen draws. */
    Optional<Topic<?, ?, ?>> of(LineMode mode) {
        return switch (mode) {
            case CIRCLE -> Optional.of(circle);
            case ELLIPSE -> Optional.of(ellipse);
            case BRIGHTNESS, SEGMENT -> Optional.of(line);
            case PEN -> Optional.empty();
        };
    }

    /**
     * A topic's method, or the user's own.
     *
     * @throws IllegalArgumentException naming the methods there are
     */
    Method<?> method(Topic<?, ?, ?> topic, String name) {
        return own.method(topic, name);
    }

    List<String> methods(LineMode mode) {
        return of(mode).stream()
                .flatMap(topic -> topic.methods().stream())
                .map(Method::name)
                .toList();
    }

    /** The hazards of circles and ellipses. */
    List<? extends Hazard<?>> hazards(LineMode mode) {
        if (mode == LineMode.CIRCLE) return circle.hazards();
        return mode == LineMode.ELLIPSE ? ellipse.hazards() : List.of();
    }

    /**
     * @throws IllegalArgumentException naming the hazards there are
     */
    ArcFigure showing(LineMode mode, String hazard) {
        Object input =
                Named.<Hazard<?>>find("hazard", hazard, List.copyOf(hazards(mode)), Hazard::name)
                        .input();
        return input instanceof Circle round ? ArcFigure.of(round) : ArcFigure.of((Ellipse) input);
    }

    /** All right pixels; empty where they are too many to judge a method by. */
    Optional<PixelRecording> exact(ArcFigure arc) {
        return arc.round() ? circle.whole(arc.circle()) : ellipse.whole(arc.ellipse());
    }

    /** The most pixels of a figure that methods are judged by. */
    int mostJudged() {
        return CircleTopic.MOST_SHOWN;
    }

    Deviation compare(ArcFigure arc, PixelRecording exact, PixelRecording actual) {
        return arc.round()
                ? circle.compare(arc.circle(), exact, actual)
                : ellipse.compare(arc.ellipse(), exact, actual);
    }

    void draw(ArcFigure arc, String method, PixelRecording out) {
        if (arc.round())
            own.method(circle, method)
                    .implementation()
                    .draw(arc.centerX(), arc.centerY(), arc.radiusX(), out);
        else
            own.method(ellipse, method)
                    .implementation()
                    .draw(arc.centerX(), arc.centerY(), arc.radiusX(), arc.radiusY(), out);
    }

    /** The walk that the method mirrors. */
    Optional<ArcWalk> walk(ArcFigure arc, String method) {
        Object drawing =
                arc.round()
                        ? own.method(circle, method).implementation()
                        : own.method(ellipse, method).implementation();
        if (drawing instanceof SteppedCircle stepped)
            return Optional.of(stepped.walk(arc.radiusX()));
        return drawing instanceof SteppedEllipse stepped
                ? Optional.of(stepped.walk(arc.radiusX(), arc.radiusY()))
                : Optional.empty();
    }

    /** The formula of a method's decision variable; "" for one without. */
    public static String decisionFormula(Method<?> method) {
        if (method.implementation() instanceof SteppedCircle stepped)
            return stepped.decisionFormula();
        return method.implementation() instanceof SteppedEllipse stepped
                ? stepped.decisionFormula()
                : "";
    }
}
