package rasterlab.app.visibility.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
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
        assertTrue(wrong(view, view.shown(VisibilityChoice.first()).visibility()) > 0, view.code());
    }

    @ParameterizedTest(name = "the bodies of {0} are all grey")
    @EnumSource(names = {"CYCLIC", "PIERCING", "COPLANAR", "COARSE"})
    void bodiesHaveTheirOwnColorsInsteadOfTheVasesGrays(HazardView view) {
        assertEquals("flat", view.shown(VisibilityChoice.first()).shading());
        var smooth = VisibilityChoice.first().withShading("phong");
        assertEquals("phong", view.shown(smooth).shading(), "chosen by the user");
    }

    @Test
    void edgeOnThePainterIsRightAsItsNameSays() {
        String shown = HazardView.EDGE_ON.shown(VisibilityChoice.first()).visibility();
        assertTrue(wrong(HazardView.EDGE_ON, shown) < 5, shown);
        assertTrue(wrong(HazardView.EDGE_ON, "painter-textbook") > 100);
    }

    private static long wrong(HazardView view, String method) {
        RenderRequest request =
                view.shown(VisibilityChoice.first()).withVisibility(method).plain(400, 300);
        var renderer = new Renderer();
        return PictureDifference.of(
                        renderer.render(request.withVisibility(Renderer.REFERENCE), () -> false),
                        renderer.render(request, () -> false))
                .wrongPixels();
    }
}
