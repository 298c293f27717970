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
    private Topics() {}

    /** All topics, in the course's order. */
    public static List<Topic<?, ?, ?>> all() {
        return List.of(
                new LineTopic(),
                new CircleTopic(),
                new EllipseTopic(),
                new FillTopic(),
                new PolygonFillTopic(),
                new LinePlaneTopic(),
                new PointInTriangleTopic(),
                new PointInPolygonTopic(),
                new TriangulateTopic(),
                new SegmentClipTopic(),
                new PolygonClipTopic(),
                new VolumeClipTopic(),
                new MatrixTopic(),
                new TransformTopic(),
                new ViewTopic(),
                new RotateTopic(),
                new AxisTopic(),
                new VisibleFacesTopic(),
                new DepthOrderTopic(),
                new DepthBufferTopic(),
                new HiddenSurfacesTopic(),
                new SplineFunctionTopic(),
                new CurveTopic(),
                new ShadeTopic(),
                new NormalsTopic(),
                new FaceTopic(),
                new ColorTopic(),
                new MappingTopic(),
                new FilterTopic());
    }

    /**
     * The topic of that name.
     *
     * @throws IllegalArgumentException if there is none; lists those there are
     */
    public static Topic<?, ?, ?> named(String name) {
        return Named.find("topic", name, all(), Topic::name);
    }
}
