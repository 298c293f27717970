package rasterlab.app.cli.run;

import java.time.Duration;
import java.util.List;
import rasterlab.app.outcome.Complaint;
import rasterlab.engine.naming.Named;

/** The topics that {@code ./lab run} reads and writes. */
public final class Runs {
    private static final Duration LONGEST = Duration.ofSeconds(60);

    private Runs() {}

    /**
     * The topic of that name.
     *
     * @throws Complaint listing the topics, if there is none
     */
    public static TopicRun named(String topic) {
        var watch = new Watch(LONGEST);
        List<TopicRun> all =
                List.of(
                        new LineRun(watch),
                        new CircleRun(watch),
                        new EllipseRun(watch),
                        new FillRun(watch),
                        new PolygonFillRun(watch),
                        new LinePlaneRun(watch),
                        new PointInTriangleRun(watch),
                        new PointInPolygonRun(watch),
                        new TriangulateRun(watch),
                        new ClipSegmentRun(watch),
                        new ClipPolygonRun(watch),
                        new ClipVolumeRun(watch),
                        new MatrixRun(watch),
                        new TransformRun(watch),
                        new ViewRun(watch),
                        new RotateRun(watch),
                        new AxisRun(watch),
                        new VisibleFacesRun(watch),
                        new DepthOrderRun(watch),
                        new DepthBufferRun(watch),
                        new HiddenSurfacesRun(watch),
                        new SplineFunctionRun(watch),
                        new CurveRun(watch),
                        new ShadeRun(watch),
                        new VertexNormalsRun(watch),
                        new ShadeFaceRun(watch),
                        new ColorRun(watch),
                        new TextureMappingRun(watch),
                        new TextureFilterRun(watch));
        try {
            return Named.find("topic", topic, all, run -> run.topic().name());
        } catch (IllegalArgumentException e) {
            throw Complaint.badInput(e.getMessage());
        }
    }

    /**
     * Passes if the topic has that method.
     *
     * @throws Complaint listing the methods, if it has not
     */
    public static void requireMethod(TopicRun run, String method) {
        try {
            run.topic().method(method);
        } catch (IllegalArgumentException e) {
            throw Complaint.badInput(e.getMessage());
        }
    }
}
