package rasterlab.app.cli.render;

import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.app.outcome.Complaint;
import rasterlab.app.outcome.ExitCode;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.catalogue.Scenes;

class RenderMemoryTest {
    @Test
    @DisplayName("a picture that does not fit is begun, or one that fits is refused")
    void refusesWhatDoesNotFit() {
        int tooMany = (int) (Runtime.getRuntime().maxMemory() / (4L * 8192 * 8192)) + 1;
        var refusal =
                assertThrows(Complaint.class, () -> RenderMemory.require(request(8192), tooMany));
        assertEquals(ExitCode.GAVE_UP, refusal.exitCode());
        assertTrue(
                refusal.getMessage().startsWith("a picture of 8192×8192 needs about "),
                refusal.getMessage());
        assertDoesNotThrow(() -> RenderMemory.require(request(64), 3));
    }

    private static RenderRequest request(int side) {
        Scene vase = Scenes.named("vase");
        return new RenderRequest(
                vase, "zfloat", "flat", "perspective", vase.defaultCamera(), side, side);
    }
}
