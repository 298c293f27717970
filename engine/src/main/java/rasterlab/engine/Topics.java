package rasterlab.engine;

import java.util.List;
import rasterlab.engine.circle.CircleTopic;
import rasterlab.engine.circle.EllipseTopic;
import rasterlab.engine.clip.polygon.PolygonClipTopic;
import rasterlab.engine.clip.segment.SegmentClipTopic;
import rasterlab.engine.clip.volume.VolumeClipTopic;
import rasterlab.engine.color.ColorTopic;
import rasterlab.engine.fill.FillTopic;
import rasterlab.engine.geometry.meeting.LinePlaneTopic;
import rasterlab.engine.light.face.FaceTopic;
import rasterlab.engine.light.normals.NormalsTopic;
import rasterlab.engine.light.shade.ShadeTopic;
import rasterlab.engine.line.LineTopic;
import rasterlab.engine.naming.Named;
import rasterlab.engine.polygon.inside.PointInPolygonTopic;
import rasterlab.engine.polygon.scan.PolygonFillTopic;
import rasterlab.engine.polygon.triangle.PointInTriangleTopic;
import rasterlab.engine.polygon.triangulation.TriangulateTopic;
import rasterlab.engine.spline.CurveTopic;
import rasterlab.engine.spline.SplineFunctionTopic;
import rasterlab.engine.study.Topic;
import rasterlab.engine.texture.filter.FilterTopic;
import rasterlab.engine.texture.mapping.MappingTopic;
import rasterlab.engine.transform.axis.AxisTopic;
import rasterlab.engine.transform.chain.TransformTopic;
import rasterlab.engine.transform.matrix.MatrixTopic;
import rasterlab.engine.transform.rotate.RotateTopic;
import rasterlab.engine.transform.view.ViewTopic;
import rasterlab.engine.visibility.depth.DepthBufferTopic;
import rasterlab.engine.visibility.faces.VisibleFacesTopic;
import rasterlab.engine.visibility.hidden.HiddenSurfacesTopic;
import rasterlab.engine.visibility.order.DepthOrderTopic;

/** The list of every topic there is. */
public final class Topics {
    /** The names of all topics, in the course's order. */
    private static final List<String> NAMES =
            List.of(
                    "line",
                    "circle",
                    "ellipse",
                    "fill",
                    "polygon-fill",
                    "line-plane",
                    "point-in-triangle",
                    "point-in-polygon",
                    "triangulate",
                    "clip-segment",
                    "clip-polygon",
                    "clip-volume",
                    "matrix",
                    "transform",
                    "view",
                    "rotate",
                    "rotate-axis",
                    "visible-faces",
                    "depth-order",
                    "depth-buffer",
                    "hidden-surfaces",
                    "spline-function",
                    "curve",
                    "shade",
                    "vertex-normals",
                    "shade-face",
                    "color",
                    "texture-mapping",
                    "texture-filter");

    private Topics() {}

    /** The names of all topics, in the course's order; none is made. */
    public static List<String> names() {
        return NAMES;
    }

    /** All topics, in the course's order. */
    public static List<Topic<?, ?, ?>> all() {
        return NAMES.stream().<Topic<?, ?, ?>>map(Topics::made).toList();
    }

    /**
     * The topic of that name; no other is made.
     *
     * @throws IllegalArgumentException if there is none; lists those there are
     */
    public static Topic<?, ?, ?> named(String name) {
        Topic<?, ?, ?> topic = made(name);
        return topic == null ? Named.find("topic", name, all(), Topic::name) : topic;
    }

    private static Topic<?, ?, ?> made(String name) {
        return switch (name) {
            case "line" -> new LineTopic();
            case "circle" -> new CircleTopic();
            case "ellipse" -> new EllipseTopic();
            case "fill" -> new FillTopic();
            case "polygon-fill" -> new PolygonFillTopic();
            case "line-plane" -> new LinePlaneTopic();
            case "point-in-triangle" -> new PointInTriangleTopic();
            case "point-in-polygon" -> new PointInPolygonTopic();
            case "triangulate" -> new TriangulateTopic();
            case "clip-segment" -> new SegmentClipTopic();
            case "clip-polygon" -> new PolygonClipTopic();
            case "clip-volume" -> new VolumeClipTopic();
            case "matrix" -> new MatrixTopic();
            case "transform" -> new TransformTopic();
            case "view" -> new ViewTopic();
            case "rotate" -> new RotateTopic();
            case "rotate-axis" -> new AxisTopic();
            case "visible-faces" -> new VisibleFacesTopic();
            case "depth-order" -> new DepthOrderTopic();
            case "depth-buffer" -> new DepthBufferTopic();
            case "hidden-surfaces" -> new HiddenSurfacesTopic();
            case "spline-function" -> new SplineFunctionTopic();
            case "curve" -> new CurveTopic();
            case "shade" -> new ShadeTopic();
            case "vertex-normals" -> new NormalsTopic();
            case "shade-face" -> new FaceTopic();
            case "color" -> new ColorTopic();
            case "texture-mapping" -> new MappingTopic();
            case "texture-filter" -> new FilterTopic();
            default -> null;
        };
    }
}
