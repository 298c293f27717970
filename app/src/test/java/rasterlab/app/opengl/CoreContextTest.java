package rasterlab.app.opengl;

import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.abort;

import org.junit.jupiter.api.Test;
import rasterlab.app.opengl.context.GlReport;
import rasterlab.app.opengl.context.NoOpenGl;
import rasterlab.app.opengl.context.OffscreenContext;

/** A call that a core profile lacks ends the whole program; skipped where there is no OpenGL. */
class CoreContextTest {
    private static OffscreenContext open(OffscreenContext.ContextProfile profile) {
        try {
            return OffscreenContext.open(profile);
        } catch (NoOpenGl e) {
            return abort(e.getMessage());
        }
    }

    @Test
    @SuppressWarnings("try") // the context is current while it is open
    void coreContextIsRefusedBeforeAnythingIsDrawn() {
        try (var context = open(OffscreenContext.ContextProfile.CORE)) {
            var refused = assertThrows(NoOpenGl.class, GlReport::ofCurrent);
            assertTrue(refused.getMessage().contains("glBegin"), refused.getMessage());
        }
    }

    @Test
    @SuppressWarnings("try") // the context is current while it is open
    void oldContextHasWhatIsNeeded() {
        try (var context = open(OffscreenContext.ContextProfile.OLD)) {
            GlReport report = GlReport.ofCurrent();
            assertTrue(report.lights() >= 8, report.toString());
            assertTrue(report.textureSide() >= 64, report.toString());
        }
    }
}
