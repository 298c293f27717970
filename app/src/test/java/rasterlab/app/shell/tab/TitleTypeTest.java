package rasterlab.app.shell.tab;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.event.ActionEvent;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTabbedPane;
import javax.swing.UIManager;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.shell.DesktopType;
import rasterlab.app.shell.LabTabs;
import rasterlab.app.shell.OffscreenPainter;
import rasterlab.app.shell.settings.LabLook;
import rasterlab.app.shell.settings.LabTheme;

@Tag("slow")
class TitleTypeTest {
    @AfterEach
    void usualTheme() throws InterruptedException {
        OffscreenPainter.onEventThread(LabTheme.LIGHT::install);
    }

    static Stream<Arguments> looks() {
        return Stream.of(Language.values())
                .flatMap(
                        language ->
                                Stream.of(LabTheme.LIGHT, LabTheme.PROJECTOR)
                                        .flatMap(
                                                theme ->
                                                        LabLook.SIZES.stream()
                                                                .map(
                                                                        size ->
                                                                                Arguments.of(
                                                                                        language,
                                                                                        theme,
                                                                                        size))));
    }

    /** The labs laid out with a sign before the titles, and a list of languages behind them. */
    private static TabbedLabs laidOut(Language language, int width) {
        Texts texts = Texts.of("shell", language);
        List<LabTab> tabs =
                LabTabs.NAMES.stream()
                        .map(name -> new LabTab(name, texts.text("tab." + name), () -> {}, null))
                        .toList();
        var pane = new TabbedLabs(tabs, failure -> {}, texts);
        pane.putClientProperty("JTabbedPane.leadingComponent", new JLabel("####"));
        var languages = new JPanel();
        languages.add(new JComboBox<>(new String[] {"Русский"}));
        pane.putClientProperty("JTabbedPane.trailingComponent", languages);
        layOut(pane, width);
        return pane;
    }

    private static void layOut(JTabbedPane pane, int width) {
        pane.setSize(width, 600);
        for (int i = 0; i < 2; i++) pane.doLayout();
    }

    private static JPanel behind(JTabbedPane pane) {
        return (JPanel) pane.getClientProperty("JTabbedPane.trailingComponent");
    }

    private static List<Rectangle> places(JTabbedPane pane) {
        var places = new ArrayList<Rectangle>();
        for (int i = 0; i < LabTabs.NAMES.size(); i++) places.add(pane.getBoundsAt(i));
        return places;
    }

    @ParameterizedTest(name = "titles are cut off, out of sight or out of order: {0}, {1}, {2} %")
    @MethodSource("looks")
    void titlesAreAllInSightInTheirOrder(Language language, LabTheme theme, int percent)
            throws InterruptedException {
        OffscreenPainter.onEventThread(
                () -> {
                    DesktopType.install(theme, percent);
                    TabbedLabs pane = laidOut(language, 1280);
                    int end = behind(pane).getParent().getX();
                    Rectangle before = new Rectangle(0, 0, 1, 1);
                    for (int i = 0; i < LabTabs.NAMES.size(); i++) {
                        Rectangle place = pane.getBoundsAt(i);
                        String title = pane.getTitleAt(i) + " at " + place;
                        int needed =
                                pane.getFontMetrics(pane.getFont()).stringWidth(pane.getTitleAt(i));
                        assertTrue(place.getMaxX() <= end, title + " runs into " + end);
                        assertTrue(place.width > needed, title + " needs " + needed);
                        boolean beside =
                                place.y == before.y && place.x >= before.x + before.width - 1;
                        boolean below = place.y >= before.y + before.height - 1;
                        assertTrue(i == 0 || beside || below, title + " after " + before);
                        before = place;
                    }
                });
    }

    @ParameterizedTest(name = "titles are the smallest text on the screen: {0}, {1}, {2} %")
    @MethodSource("looks")
    void titlesGrowWithTheTypeOfLabels(Language language, LabTheme theme, int percent)
            throws InterruptedException {
        OffscreenPainter.onEventThread(
                () -> {
                    DesktopType.install(theme, percent);
                    float title = laidOut(language, 1280).getFont().getSize2D();
                    float label = UIManager.getFont("Label.font").getSize2D();
                    assertTrue(title >= 0.6f * label, title + " beside labels of " + label);
                    assertTrue(title >= Math.min(14, label), title + " of " + label);
                });
    }

    @ParameterizedTest(name = "titles change places when one is chosen: {0}, {1}, {2} %")
    @MethodSource("looks")
    void titlesStayWhereTheyAreWhicheverIsChosen(Language language, LabTheme theme, int percent)
            throws InterruptedException {
        OffscreenPainter.onEventThread(
                () -> {
                    DesktopType.install(theme, percent);
                    TabbedLabs pane = laidOut(language, 1280);
                    List<Rectangle> first = places(pane);
                    pane.setSelectedIndex(LabTabs.NAMES.size() - 1);
                    layOut(pane, 1280);
                    assertEquals(first, places(pane));
                });
    }

    @ParameterizedTest(
            name = "a row of several is as high as one alone, or the other way: {0}, {1}, {2} %")
    @MethodSource("looks")
    void heightOfRowsGoesWithTheirCount(Language language, LabTheme theme, int percent)
            throws InterruptedException {
        OffscreenPainter.onEventThread(
                () -> {
                    DesktopType.install(theme, percent);
                    TabbedLabs pane = laidOut(language, 2600);
                    for (int width = 2600; width >= 800; width -= 7) {
                        layOut(pane, width);
                        List<Rectangle> places = places(pane);
                        long rows = places.stream().mapToInt(place -> place.y).distinct().count();
                        int high = places.get(0).height;
                        int text = pane.getFontMetrics(pane.getFont()).getHeight();
                        int one = UIScale.scale(40);
                        String found = rows + " rows of " + high + " in " + width;
                        if (rows == 1) assertEquals(one, high, found);
                        else assertTrue(high <= Math.max(one / 2 + 1, text + 8), found);
                    }
                });
    }

    @ParameterizedTest(
            name = "the line under a title seems to lie over the title below it: {0} wide")
    @CsvSource({"1280, true", "2600, false"})
    void chosenTitleIsToldByItsGroundInRowsAndByALineElsewhere(int width, boolean inRows)
            throws InterruptedException {
        OffscreenPainter.onEventThread(
                () -> {
                    DesktopType.install(LabTheme.LIGHT, 150);
                    TabbedLabs pane = laidOut(Language.RUSSIAN, width);
                    pane.setSelectedIndex(1);
                    layOut(pane, width);
                    var image = new BufferedImage(width, 600, BufferedImage.TYPE_INT_RGB);
                    Graphics2D g = image.createGraphics();
                    pane.paint(g);
                    g.dispose();
                    Rectangle chosen = pane.getBoundsAt(1);
                    Rectangle other = pane.getBoundsAt(0);
                    int across = chosen.x + 3;
                    int below = chosen.y + chosen.height - 2;
                    int ground = image.getRGB(across, chosen.y + 3);
                    assertEquals(inRows, image.getRGB(across, below) == ground, "no line");
                    boolean like = ground == image.getRGB(other.x + 3, other.y + 3);
                    assertEquals(inRows, !like, "the ground");
                });
    }

    @Test
    void arrowsDownAndUpGoToTheOtherRow() throws InterruptedException {
        OffscreenPainter.onEventThread(
                () -> {
                    DesktopType.install(LabTheme.LIGHT, 150);
                    TabbedLabs pane = laidOut(Language.RUSSIAN, 1280);
                    pane.setSelectedIndex(1);
                    press(pane, "navigateDown");
                    int below = pane.getSelectedIndex();
                    Rectangle line = pane.getBoundsAt(1);
                    Rectangle reached = pane.getBoundsAt(below);
                    assertTrue(reached.y > line.y, "tab " + below);
                    assertTrue(
                            reached.x <= line.getCenterX()
                                    && line.getCenterX() <= reached.getMaxX());
                    press(pane, "navigateUp");
                    assertEquals(line.y, pane.getBoundsAt(pane.getSelectedIndex()).y);
                });
    }

    private static void press(JTabbedPane pane, String action) {
        pane.getActionMap()
                .get(action)
                .actionPerformed(new ActionEvent(pane, ActionEvent.ACTION_PERFORMED, action));
    }

    @Test
    void whatStandsBehindTwoRowsIsAsHighAsBoth() throws InterruptedException {
        OffscreenPainter.onEventThread(
                () -> {
                    DesktopType.install(LabTheme.PROJECTOR, 200);
                    TabbedLabs pane = laidOut(Language.RUSSIAN, 1280);
                    Dimension needed = behind(pane).getPreferredSize();
                    int high = behind(pane).getParent().getHeight();
                    assertTrue(high >= needed.height, high + " for " + needed);
                    Rectangle last = pane.getBoundsAt(LabTabs.NAMES.size() - 1);
                    assertEquals(last.getMaxY(), high, 1);
                });
    }

    @Test
    void titlesThatHaveRoomAreAsLargeAsLabels() throws InterruptedException {
        OffscreenPainter.onEventThread(
                () -> {
                    DesktopType.install(LabTheme.PROJECTOR, 100);
                    assertEquals(
                            UIManager.getFont("Label.font").getSize2D(),
                            laidOut(Language.ENGLISH, 2000).getFont().getSize2D());
                });
    }

    @Test
    void titlesGrowAgainWithTheWindow() throws InterruptedException {
        OffscreenPainter.onEventThread(
                () -> {
                    DesktopType.install(LabTheme.PROJECTOR, 150);
                    TabbedLabs pane = laidOut(Language.RUSSIAN, 900);
                    Font narrow = pane.getFont();
                    int high = pane.getBoundsAt(LabTabs.NAMES.size() - 1).y;
                    layOut(pane, 2600);
                    assertTrue(pane.getFont().getSize2D() > narrow.getSize2D());
                    assertTrue(pane.getBoundsAt(LabTabs.NAMES.size() - 1).y < high, "as many rows");
                });
    }
}
