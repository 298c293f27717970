package rasterlab.engine.visibility.hidden;

import rasterlab.engine.scene.Mesh;
import rasterlab.engine.transform.PictureFit;
import rasterlab.engine.transform.Projection;
import rasterlab.engine.transform.SphericalView;
import rasterlab.engine.transform.ViewTransform;
import rasterlab.engine.visibility.ViewedMesh;

/** Views in which a test can place faces by eye: world y is to the right, z up, x to the eye. */
public final class SideView {
    static final SphericalView CAMERA = new SphericalView(0, Math.PI / 2, 500);

    private SideView() {}

    /** Parallel, one pixel per unit, the origin at pixel (width / 2, height / 2). */
    public static ViewedMesh parallel(Mesh mesh, int width, int height) {
        return new ViewedMesh(
                mesh,
                new ViewTransform(CAMERA, Projection.PARALLEL),
                new PictureFit(width, height, 1));
    }
}
