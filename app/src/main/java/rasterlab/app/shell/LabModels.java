package rasterlab.app.shell;

import java.awt.EventQueue;
import java.util.function.Consumer;
import rasterlab.app.clip.ClipLabModel;
import rasterlab.app.clip.ClipTopics;
import rasterlab.app.line.LineLabModel;
import rasterlab.app.opengl.OpenGlLabModel;
import rasterlab.app.spline.SplineLabModel;
import rasterlab.app.visibility.VisibilityLabModel;
import rasterlab.engine.line.LineTopic;
import rasterlab.engine.pipeline.Renderer;

/** The labs' models, which outlive the panels that show them; used on the event thread. */
public record LabModels(
        LineLabModel line,
        ClipLabModel clip,
        VisibilityLabModel visibility,
        SplineLabModel spline,
        OpenGlLabModel opengl)
        implements AutoCloseable {
    /**
     * Every lab as it opens.
     *
     * @param onFailure told what background work threw, on any thread
     */
    public static LabModels first(Consumer<Throwable> onFailure) {
        var renderer = new Renderer();
        return new LabModels(
                new LineLabModel(new LineTopic(), EventQueue::invokeLater, onFailure),
                new ClipLabModel(new ClipTopics(), EventQueue::invokeLater, onFailure),
                new VisibilityLabModel(renderer::render, EventQueue::invokeLater, onFailure),
                new SplineLabModel(EventQueue::invokeLater, onFailure),
                new OpenGlLabModel(EventQueue::invokeLater, onFailure));
    }

    /** Ends background work. */
    @Override
    public void close() {
        line.close();
        clip.close();
        visibility.close();
        spline.close();
        opengl.close();
    }
}
