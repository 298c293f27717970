package rasterlab.engine.visibility.hidden;

import rasterlab.engine.raster.Raster;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.transform.PictureFit;
import rasterlab.engine.transform.Projection;
import rasterlab.engine.transform.SphericalView;
import rasterlab.engine.transform.ViewTransform;
import rasterlab.engine.visibility.ViewedMesh;

/**
 * Faces and where they are seen from: an input of topic {@code hidden-surfaces}.
 *
 * @param mesh the faces
 * @param camera where the eye is
 * @param view the same as the eye sees them
 */
public record SurfaceView(Mesh mesh, SphericalView camera, ViewedMesh view) {

    /**
     * A view without a far plane.
     *
     * @param fit from the picture plane to pixels; its size is the picture's
     */
    public static SurfaceView of(
            Mesh mesh, SphericalView camera, Projection projection, PictureFit fit) {
        Raster.checkSize(fit.width(), fit.height());
        var transform = new ViewTransform(camera, projection);
        return new SurfaceView(mesh, camera, new ViewedMesh(mesh, transform, fit));
    }

    /** Perspective between a near and a far plane. */
    static SurfaceView between(
            double near, double far, Mesh mesh, SphericalView camera, PictureFit fit) {
        var transform = new ViewTransform(camera, Projection.PERSPECTIVE);
        return new SurfaceView(mesh, camera, new ViewedMesh(mesh, transform, fit, near, far));
    }

    int width() {
        return view.fit().width();
    }

    int height() {
        return view.fit().height();
    }

    @Override
    public String toString() {
        return "%d faces in %d×%d pixels".formatted(mesh.faceCount(), width(), height());
    }
}
