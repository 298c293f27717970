package rasterlab.app.clip;

import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import rasterlab.app.clip.scene.ClipPoint;
import rasterlab.app.clip.scene.ClipScene;
import rasterlab.app.clip.scene.PolygonClipScene;
import rasterlab.app.clip.scene.SegmentScene;
import rasterlab.app.clip.scene.SpacePoint;
import rasterlab.app.clip.scene.VolumePicture;
import rasterlab.app.clip.scene.VolumeScene;
import rasterlab.app.clip.scene.VolumeSpace;
import rasterlab.engine.clip.segment.ClipWindow;

/** Chooses which part of the plane the stage shows when the user has not zoomed. */
final class ClipFraming {
    /** Room around the window for the regions beside it, as a share of its size. */
    private static final double AROUND = 0.22;

    /** Points farther from the window than so many of its sizes are left out of sight. */
    private static final double FARTHEST = 6;

    private ClipFraming() {}

    static Rectangle2D of(ClipScene scene) {
        if (scene instanceof VolumeScene volume) return of(volume);
        ClipWindow window =
                scene instanceof SegmentScene segments
                        ? segments.window().rectangle()
                        : ((PolygonClipScene) scene).window().rectangle();
        double size = window.unit() > 0 ? window.unit() : 1;
        var shown = new ArrayList<ClipPoint>();
        shown.add(new ClipPoint(window.xmin() - AROUND * size, window.ymin() - AROUND * size));
        shown.add(new ClipPoint(window.xmax() + AROUND * size, window.ymax() + AROUND * size));
        for (ClipPoint place : scene.grips().values())
            if (isNear(place, window, FARTHEST * size)) shown.add(place);
        return around(shown);
    }

    private static boolean isNear(ClipPoint place, ClipWindow window, double far) {
        return place.x() >= window.xmin() - far
                && place.x() <= window.xmax() + far
                && place.y() >= window.ymin() - far
                && place.y() <= window.ymax() + far;
    }

    private static Rectangle2D of(VolumeScene scene) {
        var picture = new VolumePicture(scene);
        var shown = new ArrayList<ClipPoint>();
        for (double z : new double[] {scene.zmin(), 1})
            for (int corner = 0; corner < 4; corner++)
                shown.add(
                        picture.of(
                                new SpacePoint(corner % 2 == 0 ? -z : z, corner < 2 ? -z : z, z)));
        if (scene.space() != VolumeSpace.CANONICAL) shown.add(picture.of(new SpacePoint(0, 0, 0)));
        Rectangle2D volume = around(shown);
        double far = FARTHEST / 3 * Math.max(volume.getWidth(), volume.getHeight());
        for (ClipPoint place : scene.grips().values())
            if (Math.abs(place.x() - volume.getCenterX()) < far
                    && Math.abs(place.y() - volume.getCenterY()) < far) shown.add(place);
        return around(shown);
    }

    private static Rectangle2D around(List<ClipPoint> places) {
        var rectangle = new Rectangle2D.Double(places.get(0).x(), places.get(0).y(), 0, 0);
        places.forEach(place -> rectangle.add(place.x(), place.y()));
        return rectangle;
    }
}
