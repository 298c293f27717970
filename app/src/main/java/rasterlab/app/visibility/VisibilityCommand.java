package rasterlab.app.visibility;

import rasterlab.engine.raster.Raster;
import rasterlab.engine.transform.SphericalView;

/** The shell command that draws the picture that the lab shows, pixel by pixel. */
final class VisibilityCommand {
    private VisibilityCommand() {}

    static String of(VisibilityLabModel model) {
        VisibilityChoice choice = model.state().choice();
        SphericalView camera = choice.camera();
        Raster shown = model.state().picture().map(Picture::raster).orElse(new Raster(800, 600));
        return ("./lab render %s --visibility %s --shading %s --projection %s"
                        + " --camera %s,%s,%s --zoom %s --size %dx%d%s --out %s.png")
                .formatted(
                        choice.scene(),
                        choice.visibility(),
                        choice.shading(),
                        choice.projection(),
                        camera.thetaRadians(),
                        camera.phiRadians(),
                        camera.rho(),
                        choice.zoom(),
                        shown.width(),
                        shown.height(),
                        model.drawsEdges() ? " --outline" : "",
                        choice.scene());
    }
}
