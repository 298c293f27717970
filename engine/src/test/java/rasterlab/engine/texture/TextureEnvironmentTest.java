package rasterlab.engine.texture;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.engine.texture.TextureEnvironment.Mode;

class TextureEnvironmentTest {
    private static final int SURFACE = 0xCC336699;
    private static final int TEXEL = 0x80FF8040;
    private static final int GREY_TEXEL = 0x80404040;
    private static final int ENVIRONMENT = 0x00FFFF00;

    /** The table of chapter 15, computed by hand: 0xCC·0x80/255 = 0x66, and so on. */
    @ParameterizedTest(name = "chapter 15: {0} of {1} components")
    @CsvSource({
        "MODULATE, 1, CC0D1A26",
        "MODULATE, 2, 660D1A26",
        "MODULATE, 3, CC333326",
        "MODULATE, 4, 66333326",
        "DECAL, 3, CCFF8040",
        "DECAL, 4, CC99736C",
        "BLEND, 1, CC668C73",
        "BLEND, 2, 66668C73",
        "BLEND, 3, CCFFB373",
        "BLEND, 4, 66FFB373",
        "REPLACE, 1, CC404040",
        "REPLACE, 2, 80404040",
        "REPLACE, 3, CCFF8040",
        "REPLACE, 4, 80FF8040",
    })
    void combines(Mode mode, int components, String argb) {
        int texel = components < 3 ? GREY_TEXEL : TEXEL;
        var environment = new TextureEnvironment(mode, components, ENVIRONMENT);
        assertEquals(
                argb,
                "%08X".formatted(environment.combine(SURFACE, texel)),
                mode + " " + components);
        int[] many = {1, SURFACE, 2};
        environment.combine(2, many, new int[] {0, texel, 0});
        assertEquals(argb, "%08X".formatted(many[1]), mode + " " + components + ", many");
        assertEquals(2, many[2], "beyond the count");
    }

    @Test
    void everyProductIsRoundedToTheNearestLevel() {
        var modulate = new TextureEnvironment(Mode.MODULATE, 1, 0);
        for (int a = 0; a < 256; a++)
            for (int b = 0; b < 256; b++)
                assertEquals(
                        Math.round(a * b / 255.0),
                        modulate.combine(a, b * 0x010101) & 255,
                        a + "·" + b);
    }

    @Test
    void whiteTexelAndOpaqueSurfaceChangeNothing() {
        var random = new Random(15);
        for (int components = 1; components <= 4; components++) {
            var modulate = new TextureEnvironment(Mode.MODULATE, components, 0);
            int surface = random.nextInt();
            assertEquals(surface, modulate.combine(surface, -1));
        }
    }
}
