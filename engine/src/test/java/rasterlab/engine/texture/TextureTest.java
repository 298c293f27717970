package rasterlab.engine.texture;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.Random;
import java.util.stream.Stream;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.joml.Matrix4d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

class TextureTest {
    @ParameterizedTest(name = "{0}×{1} has no {2} levels")
    @CsvSource({"1,1,1", "2,2,2", "3,5,3", "8,2,4", "1,9,4", "256,256,9"})
    void sizesAreHalvedDownToOneTexel(int width, int height, int levels) {
        Texture texture = Texture.of(width, height, 4, new int[width * height]);
        assertEquals(levels, texture.levelCount());
        assertEquals(1, texture.level(levels - 1).width());
        assertEquals(1, texture.level(levels - 1).height());
    }

    @Test
    void middleColumnOfAnOddWidthIsShared() {
        Texture texture = grays(3, 1, 0, 90, 240);
        assertEquals(gray((0 + 90 + 240) / 3), texture.level(1).texel(0, 0));
        Texture wide = grays(5, 1, 10, 20, 200, 30, 40);
        assertEquals(gray((10 + 20 + 100) / 2.5), wide.level(1).texel(0, 0));
        assertEquals(gray((100 + 30 + 40) / 2.5), wide.level(1).texel(1, 0));
    }

    /** A rounding from level to level would drift by up to half a level each time. */
    @Property(tries = 60)
    void lastLevelIsTheMeanOfAllTexels(
            @ForAll @IntRange(min = 1, max = 40) int width,
            @ForAll @IntRange(min = 1, max = 40) int height,
            @ForAll long seed) {
        int[] argb = new Random(seed).ints((long) width * height).toArray();
        Texture texture = Texture.of(width, height, 4, argb);
        int last = texture.level(texture.levelCount() - 1).texel(0, 0);
        for (int shift = 0; shift < 32; shift += 8) {
            double sum = 0;
            for (int texel : argb) sum += texel >>> shift & 255;
            assertEquals(sum / argb.length, last >>> shift & 255, 0.5 + 1e-9);
        }
    }

    @Test
    void luminanceIsGrayAndOpaqueWithoutAlpha() {
        assertEquals(0xFF808080, Texture.of(1, 1, 1, new int[] {0x10801234}).level(0).texel(0, 0));
        assertEquals(0x10808080, Texture.of(1, 1, 2, new int[] {0x10801234}).level(0).texel(0, 0));
        assertEquals(0xFF801234, Texture.of(1, 1, 3, new int[] {0x10801234}).level(0).texel(0, 0));
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void refuses(Executable call, String message) {
        assertEquals(message, assertThrows(IllegalArgumentException.class, call).getMessage());
    }

    static Stream<Arguments> mistakes() {
        return Stream.of(
                mistake(
                        "a texture of nothing",
                        () -> Texture.of(0, 1, 4, new int[0]),
                        "texture's width must be from 1 to 8192, got 0"),
                mistake(
                        "a size whose product overflows",
                        () -> Texture.of(8192, 1 << 20, 4, new int[0]),
                        "texture's height must be from 1 to 8192, got 1048576"),
                mistake(
                        "a row is missing",
                        () -> Texture.of(2, 2, 4, new int[2]),
                        "a texture of 2×2 needs 4 texels, got 2"),
                mistake(
                        "a fifth component",
                        () -> Texture.of(1, 1, 5, new int[1]),
                        "components must be from 1 to 4, got 5"),
                mistake(
                        "the course's table has no DECAL for luminance",
                        () -> new TextureEnvironment(TextureEnvironment.Mode.DECAL, 2, 0),
                        "DECAL needs a texture of 3 or 4 components, got 2"));
    }

    private static Arguments mistake(String name, Executable call, String message) {
        return argumentSet(name, call, message);
    }

    @Test
    void textureMatrixTakesPointsAsRows() {
        float[] s = {1, 0};
        float[] t = {2, 0};
        var shifted =
                new Matrix4d(
                        2, 0, 0, 0, //
                        0, 3, 0, 0, //
                        0, 0, 1, 0, //
                        0.5, 0.25, 0, 1);
        new TextureMatrix(shifted).transform(2, s, t);
        assertArrayEquals(new float[] {2.5f, 0.5f}, s);
        assertArrayEquals(new float[] {6.25f, 0.25f}, t);
    }

    @Test
    void textureMatrixDividesByItsLastNumber() {
        float[] s = {1};
        float[] t = {2};
        var projective =
                new Matrix4d(
                        1, 0, 0, 1, //
                        0, 1, 0, 0, //
                        0, 0, 1, 0, //
                        0, 0, 0, 1);
        new TextureMatrix(projective).transform(1, s, t);
        assertEquals(0.5f, s[0]);
        assertEquals(1, t[0]);
    }

    static Texture grays(int width, int height, int... levels) {
        var argb = new int[levels.length];
        for (int i = 0; i < levels.length; i++) argb[i] = gray(levels[i]);
        return Texture.of(width, height, 4, argb);
    }

    static int gray(double level) {
        return 0xFF000000 | (int) (level + 0.5) * 0x010101;
    }
}
