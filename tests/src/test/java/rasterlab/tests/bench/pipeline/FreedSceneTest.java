package rasterlab.tests.bench.pipeline;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.lang.ref.WeakReference;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.scene.Mesh;

@Tag("slow")
class FreedSceneTest {
    /** Where memory is short at any moment, so that what is kept only for speed is given up. */
    private static final List<String> SHORT_OF_MEMORY =
            List.of("-Xmx200m", "-XX:SoftRefLRUPolicyMSPerMB=0");

    /** Far more collections than what is not held needs to be freed. */
    private static final int COLLECTIONS = 50;

    @Test
    @DisplayName("a scene that nobody shows any more fills the memory until the next is drawn")
    void sceneThatNobodyShowsIsFreed() throws IOException, InterruptedException {
        var out = new ByteArrayOutputStream();
        var err = new ByteArrayOutputStream();
        int code =
                new OwnProcess(SHORT_OF_MEMORY, FreedSceneTest.class, List.of())
                        .run(printTo(out), printTo(err));
        assertEquals("", text(err).replaceAll("(?m)^WARNING.*\\R", ""));
        assertEquals(0, code);
        assertEquals("all freed", text(out).strip(), "scenes that the renderer still holds");
    }

    private static PrintStream printTo(ByteArrayOutputStream bytes) {
        return new PrintStream(bytes, true, StandardCharsets.UTF_8);
    }

    private static String text(ByteArrayOutputStream bytes) {
        return bytes.toString(StandardCharsets.UTF_8);
    }

    /** Prints which scenes are held after they were drawn. */
    public static void main(String[] arguments) {
        boolean all = true;
        try (var renderer = new Renderer()) {
            for (String visibility : List.of(Renderer.PIPELINE, Renderer.AUTO))
                for (TorusLook look : TorusLook.values())
                    if (isHeld(drawn(renderer, visibility, look))) {
                        System.out.println(visibility + ", " + look.text());
                        all = false;
                    }
        }
        if (all) System.out.println("all freed");
    }

    private static WeakReference<Mesh> drawn(Renderer renderer, String visibility, TorusLook look) {
        var scene = new TorusScene(10_000, 320, 200);
        var request = scene.request(look).withVisibility(visibility);
        renderer.render(request, new Raster(scene.width(), scene.height()), () -> false);
        return new WeakReference<>(request.scene().mesh());
    }

    private static boolean isHeld(WeakReference<Mesh> mesh) {
        for (int k = 0; k < COLLECTIONS && mesh.get() != null; k++) System.gc();
        return mesh.get() != null;
    }
}
