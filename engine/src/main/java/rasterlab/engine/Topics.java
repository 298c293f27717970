package rasterlab.engine;

import java.util.ArrayList;
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
import rasterlab.engine.spline.curve.CurveTopic;
import rasterlab.engine.spline.function.SplineFunctionTopic;
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
import rasterlab.engine.visibility.triangle.DepthTriangleTopic;

/** The list of every topic there is: the only one that is kept by hand. */
public final class Topics {
    private Topics() {}

    /**
     * Goes through the course in its order, one line a topic, to the topic that is asked for.
     *
     * @param passed takes the names of all topics on the way
     * @return null where no topic has that name
     */
    private static Topic<?, ?, ?> find(String asked, List<String> passed) {
        if (is("line", asked, passed)) return new LineTopic();
        if (is("circle", asked, passed)) return new CircleTopic();
        if (is("ellipse", asked, passed)) return new EllipseTopic();
        if (is("fill", asked, passed)) return new FillTopic();
        if (is("polygon-fill", asked, passed)) return new PolygonFillTopic();
        if (is("line-plane", asked, passed)) return new LinePlaneTopic();
        if (is("point-in-triangle", asked, passed)) return new PointInTriangleTopic();
        if (is("point-in-polygon", asked, passed)) return new PointInPolygonTopic();
        if (is("triangulate", asked, passed)) return new TriangulateTopic();
        if (is("clip-segment", asked, passed)) return new SegmentClipTopic();
        if (is("clip-polygon", asked, passed)) return new PolygonClipTopic();
        if (is("clip-volume", asked, passed)) return new VolumeClipTopic();
        if (is("matrix", asked, passed)) return new MatrixTopic();
        if (is("transform", asked, passed)) return new TransformTopic();
        if (is("view", asked, passed)) return new ViewTopic();
        if (is("rotate", asked, passed)) return new RotateTopic();
        if (is("rotate-axis", asked, passed)) return new AxisTopic();
        if (is("visible-faces", asked, passed)) return new VisibleFacesTopic();
        if (is("depth-order", asked, passed)) return new DepthOrderTopic();
        if (is("depth-buffer", asked, passed)) return new DepthBufferTopic();
        if (is("depth-triangle", asked, passed)) return new DepthTriangleTopic();
        if (is("hidden-surfaces", asked, passed)) return new HiddenSurfacesTopic();
        if (is("spline-function", asked, passed)) return new SplineFunctionTopic();
        if (is("curve", asked, passed)) return new CurveTopic();
        if (is("shade", asked, passed)) return new ShadeTopic();
        if (is("vertex-normals", asked, passed)) return new NormalsTopic();
        if (is("shade-face", asked, passed)) return new FaceTopic();
        if (is("color", asked, passed)) return new ColorTopic();
        if (is("texture-mapping", asked, passed)) return new MappingTopic();
        if (is("texture-filter", asked, passed)) return new FilterTopic();
        return null;
    }

    private static boolean is(String name, String asked, List<String> passed) {
        passed.add(name);
        return name.equals(asked);
    }

    /** The names of all topics, in the course's order; none is made. */
    public static List<String> names() {
        var names = new ArrayList<String>();
        find("", names);
        return List.copyOf(names);
    }

    /** All topics, in the course's order. */
    public static List<Topic<?, ?, ?>> all() {
        return names().stream().<Topic<?, ?, ?>>map(Topics::named).toList();
    }

    /**
     * The topic of that name; no other is made.
     *
     * @throws IllegalArgumentException if there is none; lists those there are
     */
    public static Topic<?, ?, ?> named(String name) {
        Topic<?, ?, ?> topic = find(name, new ArrayList<>());
        return topic == null ? Named.find("topic", name, all(), Topic::name) : topic;
    }
}
