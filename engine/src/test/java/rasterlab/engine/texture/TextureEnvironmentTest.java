package rasterlab.engine.texture;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import rasterlab.engine.texture.TextureEnvironment.Mode;

class TextureEnvironmentTest {
    private static final int SURFACE = 0xCC336699;
    private static final int TEXEL = 0x80FF8040;
    private static final int GRAY_TEXEL = 0x80404040;
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
        int texel = components < 3 ? GRAY_TEXEL : TEXEL;
        var environment = new TextureEnvironment(mode, components, ENVIRONMENT);
        assertEquals(
                argb,
                "%08X".formatted(environment.combine(SURFACE, texel)),
                mode + " " + components);
        for (int count = 1; count < 20; count++) {
            String what = "%s %d, %d pixels".formatted(mode, components, count);
            int[] many = new int[count + 1];
            Arrays.fill(many, SURFACE);
            int[] texels = new int[count + 1];
            Arrays.fill(texels, texel);
            environment.combine(count, many, texels);
            for (int i = 0; i < count; i++) assertEquals(argb, "%08X".formatted(many[i]), what);
            assertEquals(SURFACE, many[count], what + ": beyond the count");
        }
    }

    @Test
    void everyProductIsRoundedToTheNearestLevel() {
        var modulate = new TextureEnvironment(Mode.MODULATE, 4, 0);
        int[] surface = new int[256];
        int[] texel = new int[256];
        for (int a = 0; a < 256; a++) {
            for (int b = 0; b < 256; b++) {
                surface[b] = a * 0x01010101;
                texel[b] = b * 0x01010101;
            }
            modulate.combine(256, surface, texel);
            for (int b = 0; b < 256; b++) {
                int product = (int) Math.round(a * b / 255.0) * 0x01010101;
                assertEquals(product, surface[b], a + "·" + b);
                int single = modulate.combine(a * 0x01010101, b * 0x01010101);
                assertEquals(product, single, a + "·" + b);
            }
        }
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

    /** Alpha may come from an opaque surface alone. */
    @ParameterizedTest(name = "{0}: a surface that shows through is said to be hidden, or not")
    @EnumSource
    void surfaceIsHiddenWhereItsColorChangesNothing(Mode mode) {
        int texel = 0x80B03060;
        for (int components = mode == Mode.DECAL ? 3 : 1; components <= 4; components++) {
            var environment = new TextureEnvironment(mode, components, 0x7F402010);
            boolean same =
                    environment.combine(0xFF102030, texel)
                            == environment.combine(0xFFF0C0A0, texel);
            assertEquals(same, environment.hidesSurface(), components + " components");
        }
    }
}
