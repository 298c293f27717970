package rasterlab.app.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import javax.swing.JPanel;
import javax.swing.JTabbedPane;
import javax.swing.UIManager;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class TitleTypeTest {
    private static final List<String> TITLES =
            List.of(
                    "Coordinates",
                    "Lines",
                    "Polygons",
                    "Clipping",
                    "Hidden surfaces",
                    "Lighting",
                    "Splines",
                    "OpenGL",
                    "Speed & accuracy",
                    "Exercises");

    @AfterEach
    void usualTheme() throws InterruptedException {
        OffscreenPainter.onEventThread(LabTheme.LIGHT::install);
    }

    private static JTabbedPane laidOut(int width) {
        var pane = new JTabbedPane();
        for (String title : TITLES) pane.addTab(title, new JPanel());
        pane.setTabLayoutPolicy(JTabbedPane.SCROLL_TAB_LAYOUT);
        pane.setSize(width, 600);
        TitleType.fit(pane);
        pane.doLayout();
        return pane;
    }

    @ParameterizedTest(name = "only some of the titles are in sight at {0} %")
    @ValueSource(ints = {100, 150, 200})
    void projectorsTitlesAreAllInSight(int percent) throws InterruptedException {
        OffscreenPainter.onEventThread(
                () -> {
                    DesktopType.install(LabTheme.PROJECTOR, percent);
                    JTabbedPane pane = laidOut(1060);
                    for (int i = 0; i < TITLES.size(); i++)
                        assertTrue(
                                pane.getBoundsAt(i).getMaxX() <= 1060,
                                TITLES.get(i) + " at " + pane.getBoundsAt(i));
                });
    }

    @Test
    void titlesThatHaveRoomAreAsLargeAsLabels() throws InterruptedException {
        OffscreenPainter.onEventThread(
                () -> {
                    DesktopType.install(LabTheme.PROJECTOR, 100);
                    assertEquals(
                            UIManager.getFont("Label.font").getSize2D(),
                            laidOut(2000).getFont().getSize2D());
                });
    }

    @Test
    void titlesGrowAgainWithTheWindow() throws InterruptedException {
        OffscreenPainter.onEventThread(
                () -> {
                    DesktopType.install(LabTheme.PROJECTOR, 150);
                    JTabbedPane pane = laidOut(900);
                    float narrow = pane.getFont().getSize2D();
                    pane.setSize(2400, 600);
                    TitleType.fit(pane);
                    assertTrue(pane.getFont().getSize2D() > narrow);
                });
    }
}
