package rasterlab.app.visibility;

import rasterlab.engine.raster.Raster;
import rasterlab.engine.transform.SphericalView;

/**
 * The shell command that draws what the lab shows.
 *
 * <p>A zoomed picture is asked for larger in the same proportion: the scene has the same size in
 * pixels, with more around it.
 */
final class VisibilityCommand {
    private VisibilityCommand() {}

    static String of(VisibilityLabState state) {
        VisibilityChoice choice = state.choice();
        SphericalView camera = choice.camera();
        Raster shown = state.picture().map(Picture::raster).orElse(new Raster(800, 600));
        return ("./lab render %s --visibility %s --shading %s --projection %s"
                        + " --camera %s,%s,%s --size %dx%d --out %s.png")
                .formatted(
                        choice.scene(),
                        choice.visibility(),
                        choice.shading(),
                        choice.projection(),
                        camera.thetaRadians(),
                        camera.phiRadians(),
                        camera.rho(),
                        larger(shown.width(), choice.zoom()),
                        larger(shown.height(), choice.zoom()),
                        choice.scene());
    }

    private static long larger(int side, double zoom) {
        return Math.max(1, Math.min(Raster.LARGEST_SIDE, Math.round(side * zoom)));
    }
}
