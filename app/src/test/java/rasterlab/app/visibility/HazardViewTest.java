package rasterlab.app.visibility;

import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.raster.PictureDifference;

class HazardViewTest {
    @ParameterizedTest(name = "the view shows no wrong pixel: {0}")
    @EnumSource(
            names = {
                "ROUNDED",
                "THREE_CORNERS",
                "MEAN",
                "CYCLIC",
                "PIERCING",
                "COPLANAR",
                "COARSE"
            })
    void methodFailsInTheView(HazardView view) {
        RenderRequest request = view.shown(VisibilityChoice.first()).plain(400, 300);
        var renderer = new Renderer();
        PictureDifference difference =
                PictureDifference.of(
                        renderer.render(request.withVisibility(Renderer.REFERENCE), () -> false),
                        renderer.render(request, () -> false));
        assertTrue(difference.wrongPixels() > 0, view.code());
    }
}
