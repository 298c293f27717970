package rasterlab.engine.visibility;

import rasterlab.engine.scene.Mesh;
import rasterlab.engine.transform.PictureFit;
import rasterlab.engine.transform.Projection;
import rasterlab.engine.transform.SphericalView;
import rasterlab.engine.transform.ViewTransform;

/** Views in which a test can place faces by eye: world y is to the right, z up, x to the eye. */
final class SideView {
    static final SphericalView CAMERA = new SphericalView(0, Math.PI / 2, 500);

    private SideView() {}

    /** Parallel, one pixel per unit, the origin at pixel (width / 2, height / 2). */
    static ViewedMesh parallel(Mesh mesh, int width, int height) {
        return new ViewedMesh(
                mesh,
                new ViewTransform(CAMERA, Projection.PARALLEL),
                new PictureFit(width, height, 1));
    }
}
