package rasterlab.app.visibility.scene;

import rasterlab.engine.scene.Mesh;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.transform.Projection;

/** How far a scene reaches from the middle of its picture, however it is turned. */
public final class SceneReach {
    private SceneReach() {}

    /**
     * The reach in pixels of a picture of 800×600 at a zoom of 1. A ball of radius r around the
     * middle is seen from the distance ρ as a disc of radius r·ρ / √(ρ² − r²); infinite from within
     * it.
     */
    public static double of(VisibilityChoice choice) {
        Scene scene = choice.shown().scene();
        double r = radius(scene.mesh());
        double rho = choice.camera().rho();
        boolean central = Projection.named(choice.projection()) == Projection.PERSPECTIVE;
        if (!central) return scene.pictureScale() * r;
        if (r >= rho) return Double.POSITIVE_INFINITY;
        return scene.pictureScale() * r * rho / Math.sqrt(rho * rho - r * r);
    }

    private static double radius(Mesh mesh) {
        double farthest = 0;
        for (int v = 0; v < mesh.vertexCount(); v++) {
            double x = mesh.x(v);
            double y = mesh.y(v);
            double z = mesh.z(v);
            farthest = Math.max(farthest, x * x + y * y + z * z);
        }
        return Math.sqrt(farthest);
    }
}
