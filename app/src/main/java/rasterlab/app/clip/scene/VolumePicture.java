package rasterlab.app.clip.scene;

import org.joml.Matrix4d;
import org.joml.Vector4d;
import rasterlab.engine.transform.ProjectionMatrices;

/** Where points of the normalised space are in the picture of the space that is shown. */
public final class VolumePicture {
    private final VolumeSpace space;
    private final VolumeViewpoint view;
    private final Matrix4d toShown;
    private final Matrix4d toNormalized;

    public VolumePicture(VolumeScene scene) {
        space = scene.space();
        view = scene.view();
        toNormalized = space == VolumeSpace.EYE ? scene.screen().normalize() : new Matrix4d();
        toShown =
                space == VolumeSpace.CANONICAL
                        ? ProjectionMatrices.canonical(scene.zmin())
                        : new Matrix4d(toNormalized).invert();
    }

    /** The picture of a point; after the division not finite for one at the eye. */
    public ClipPoint of(SpacePoint normalized) {
        return view.picture(shown(normalized));
    }

    /** The point in the space that is shown. */
    public SpacePoint shown(SpacePoint normalized) {
        return image(toShown, normalized);
    }

    /** Whether a picture between two points is the straight line between their pictures. */
    public boolean inFront(SpacePoint normalized) {
        return space != VolumeSpace.CANONICAL || normalized.z() > 0;
    }

    /** The point moved parallel to the picture so that it is seen at that place. */
    SpacePoint lifted(SpacePoint normalized, ClipPoint picture) {
        return image(toNormalized, view.lifted(shown(normalized), picture));
    }

    private static SpacePoint image(Matrix4d matrix, SpacePoint p) {
        var h = matrix.transform(new Vector4d(p.x(), p.y(), p.z(), 1));
        return new SpacePoint(h.x / h.w, h.y / h.w, h.z / h.w);
    }
}
