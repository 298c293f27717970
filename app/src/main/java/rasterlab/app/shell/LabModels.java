package rasterlab.app.shell;

import java.awt.EventQueue;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import rasterlab.app.canvas.Kept;
import rasterlab.app.canvas.PictureMaker;
import rasterlab.app.clip.ClipLabModel;
import rasterlab.app.clip.ClipTopics;
import rasterlab.app.coordinates.CoordinatesLabModel;
import rasterlab.app.exercise.ExerciseLabModel;
import rasterlab.app.light.LightLabModel;
import rasterlab.app.line.LineLabModel;
import rasterlab.app.opengl.OpenGlLabModel;
import rasterlab.app.polygon.PolygonLabModel;
import rasterlab.app.polygon.PolygonTopics;
import rasterlab.app.spline.SplineLabModel;
import rasterlab.app.study.StudyLabModel;
import rasterlab.app.visibility.VisibilityLabModel;
import rasterlab.engine.Topics;
import rasterlab.engine.line.LineTopic;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.exercises.catalogue.Catalogue;

/** The labs' models, which outlive the panels that show them; used on the event thread. */
public record LabModels(
        CoordinatesLabModel coordinates,
        LineLabModel line,
        PolygonLabModel polygon,
        ClipLabModel clip,
        VisibilityLabModel visibility,
        LightLabModel light,
        SplineLabModel spline,
        OpenGlLabModel opengl,
        StudyLabModel study,
        ExerciseLabModel exercises)
        implements AutoCloseable {
    /**
     * Every lab as it opens.
     *
     * @param onFailure told what background work threw, on any thread
     */
    public static LabModels first(Consumer<Throwable> onFailure) {
        return first(EventQueue::invokeLater, onFailure);
    }

    /**
     * Every lab as it opens, made on one thread and used on that of the events.
     *
     * @param events runs what it is given on one thread, in order, once the models are made
     * @param onFailure told what background work threw, on any thread
     */
    static LabModels first(Executor events, Consumer<Throwable> onFailure) {
        return new LabModels(
                new CoordinatesLabModel(events, onFailure),
                new LineLabModel(new LineTopic(), events, onFailure),
                new PolygonLabModel(new PolygonTopics(), events, onFailure),
                new ClipLabModel(new ClipTopics(), events, onFailure),
                new VisibilityLabModel(PictureMaker.by(new Renderer()), events, onFailure),
                new LightLabModel(events, onFailure),
                new SplineLabModel(events, onFailure),
                new OpenGlLabModel(events, onFailure),
                new StudyLabModel(Topics.all(), events, onFailure),
                new ExerciseLabModel(() -> Catalogue.builtIn().all(), events, onFailure));
    }

    /** What opens as it was left, by the name under which it is kept. */
    Map<String, Kept<?>> kept() {
        var kept = new LinkedHashMap<String, Kept<?>>();
        kept.put("coordinates", coordinates);
        kept.put("coordinates.views", coordinates.views());
        kept.put("coordinates.transformations", coordinates.transformations());
        kept.put("coordinates.stack", coordinates.stack());
        kept.put("coordinates.rotation", coordinates.rotation());
        kept.put("coordinates.meeting", coordinates.meeting());
        kept.put("line", line);
        kept.put("line.figures", line.figures());
        kept.put("line.mode", line.keptMode());
        kept.put("polygon", polygon);
        kept.put("clip", clip);
        kept.put("visibility", visibility);
        kept.put("visibility.rows", visibility.rows());
        kept.put("visibility.rows.open", visibility.rows().keptOpen());
        kept.put("light", light);
        kept.put("light.rows", light.rows());
        kept.put("light.rows.open", light.rows().keptOpen());
        kept.put("spline", spline);
        kept.put("spline.curve", spline.curve());
        kept.put("spline.function", spline.function());
        kept.put("opengl", opengl);
        kept.put("study", study);
        kept.put("exercises", exercises);
        return kept;
    }

    /** Ends background work. */
    @Override
    public void close() {
        coordinates.close();
        line.close();
        polygon.close();
        clip.close();
        visibility.close();
        light.close();
        spline.close();
        opengl.close();
        study.close();
        exercises.close();
    }
}
