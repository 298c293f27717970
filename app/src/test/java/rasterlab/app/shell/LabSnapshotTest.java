package rasterlab.app.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.util.HashSet;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.language.Language;
import rasterlab.app.rooms.LabRooms;
import rasterlab.app.shell.settings.LabTheme;

@Tag("slow")
class LabSnapshotTest {
    @AfterEach
    void usualLook() throws InterruptedException {
        OffscreenPainter.onEventThread(UsualLook::install);
    }

    static Stream<Arguments> looks() {
        return Stream.of(LabTheme.values())
                .flatMap(
                        theme ->
                                Stream.of(Language.values())
                                        .map(language -> Arguments.of(theme, language)));
    }

    @ParameterizedTest(name = "the line is not drawn: {0}, {1}")
    @MethodSource("looks")
    void showsTheLineInItsMethodsColor(LabTheme theme, Language language)
            throws InterruptedException {
        BufferedImage image = LabSnapshot.of("line", theme, language, models -> {}, 1280, 800);
        assertEquals(1280, image.getWidth());
        Set<Integer> colors = colors(image);
        assertTrue(
                colors.contains(
                        0xFF000000 | LabRooms.card("line").colors().of("bresenham").getRGB()));
    }

    @ParameterizedTest(name = "the picture is not waited for: {0}, {1}")
    @MethodSource("looks")
    void showsTheVaseWithoutADisplay(LabTheme theme, Language language)
            throws InterruptedException {
        BufferedImage image =
                LabSnapshot.of("visibility", theme, language, models -> {}, 1280, 800);
        // 270 side faces, each with its own tone: dozens of different colours.
        assertTrue(colors(image.getSubimage(10, 110, 800, 600)).size() > 40);
    }

    @ParameterizedTest(name = "the clipped segments are not drawn: {0}, {1}")
    @MethodSource("looks")
    void showsWhatIsLeftInItsMethodsColor(LabTheme theme, Language language)
            throws InterruptedException {
        BufferedImage image = LabSnapshot.of("clip", theme, language, models -> {}, 1280, 800);
        BufferedImage stage = image.getSubimage(60, 300, 600, 420);
        int left =
                0xFF000000 | LabRooms.card("clip-segment").colors().of("cohen-sutherland").getRGB();
        assertTrue(colors(stage).contains(left));
    }

    @Test
    void refusesAnUnknownTab() {
        var refused =
                assertThrows(
                        IllegalArgumentException.class,
                        () ->
                                LabSnapshot.of(
                                        "cooking",
                                        LabTheme.LIGHT,
                                        Language.ENGLISH,
                                        models -> {},
                                        900,
                                        600));
        assertTrue(refused.getMessage().contains("visibility"), refused.getMessage());
    }

    private static Set<Integer> colors(BufferedImage image) {
        var colors = new HashSet<Integer>();
        for (int y = 0; y < image.getHeight(); y++)
            for (int x = 0; x < image.getWidth(); x++) colors.add(image.getRGB(x, y));
        return colors;
    }
}
