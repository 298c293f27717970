package rasterlab.engine.visibility;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.catalogue.Scenes;
import rasterlab.engine.transform.PictureFit;
import rasterlab.engine.transform.Projection;
import rasterlab.engine.transform.ViewTransform;

class SeenPointTest {
    private static ViewedMesh view(Scene scene, Projection projection) {
        return new ViewedMesh(
                scene.mesh(),
                new ViewTransform(scene.defaultCamera(), projection),
                PictureFit.of(400, 300, scene.pictureScale()));
    }

    @Test
    void pointOfASphereLiesOnItAndItsNormalPointsOutwards() {
        Scene sphere = Scenes.named("sphere", 128);
        for (Projection projection : new Projection[] {Projection.PERSPECTIVE, Projection.PARALLEL})
            for (int x = 170; x < 230; x += 9) {
                SeenPoint point = SeenPoint.at(view(sphere, projection), x, 140).orElseThrow();
                double[] p = point.position();
                double[] n = point.normal();
                double radius = Math.sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
                assertEquals(100, radius, 0.2);
                for (int axis = 0; axis < 3; axis++) assertEquals(p[axis] / radius, n[axis], 2e-3);
                assertFalse(point.behind());
            }
    }

    @Test
    void pointIsSeenThroughItsPixelAgain() {
        Scene torus = Scenes.named("torus");
        ViewedMesh view = view(torus, Projection.PERSPECTIVE);
        SeenPoint point = SeenPoint.at(view, 130, 150).orElseThrow();
        double[] p = point.position();
        ViewTransform transform = view.transform();
        double shrink = transform.distance() / transform.toEye(2, p[0], p[1], p[2]);
        assertEquals(130, view.fit().toPixelX(transform.toEye(0, p[0], p[1], p[2]) * shrink), 1e-9);
        assertEquals(150, view.fit().toPixelY(transform.toEye(1, p[0], p[1], p[2]) * shrink), 1e-9);
    }

    @Test
    void backgroundShowsNoPoint() {
        assertTrue(
                SeenPoint.at(view(Scenes.named("sphere"), Projection.PERSPECTIVE), 2, 2).isEmpty());
    }
}
