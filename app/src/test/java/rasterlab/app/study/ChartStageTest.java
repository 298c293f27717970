package rasterlab.app.study;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.EventQueue;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.shell.OffscreenPainter;
import rasterlab.app.shell.settings.LabTheme;
import rasterlab.engine.Topics;

@Tag("slow")
@Timeout(300)
class ChartStageTest {
    private static final int WIDTH = 900;
    private static final int HEIGHT = 640;

    private final List<Throwable> failures = new CopyOnWriteArrayList<>();
    private final CountDownLatch measured = new CountDownLatch(1);
    private StudyLabModel model;

    @AfterEach
    void close() throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    if (model != null) model.close();
                    LabTheme.LIGHT.install();
                });
        assertEquals(List.of(), failures);
    }

    @Test
    void typeGrowsWithTheWindowsButNotBeyondTheRoom() {
        assertEquals(1.5, ChartStage.type(1200, 800, 1.5));
        assertEquals(1, ChartStage.type(560, 900, 1.5));
        assertEquals(0.5, ChartStage.type(900, 200, 1));
    }

    @Test
    void titleIsLargerInLargerType() throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    model = new StudyLabModel(Topics.all(), EventQueue::invokeLater, failures::add);
                    model.listen(
                            state -> {
                                boolean whole = state.study().isPresent();
                                if (whole && !state.work().running()) measured.countDown();
                            });
                    model.measure();
                });
        measured.await();
        int usual = titleRows(100);
        int larger = titleRows(150);
        assertTrue(larger >= 1.3 * usual, usual + " and " + larger + " rows");
    }

    /** Rows of the first words below the stage's frame. */
    private int titleRows(int percent) throws Exception {
        var stage = new AtomicReference<ChartStage>();
        EventQueue.invokeAndWait(
                () -> {
                    LabTheme.LIGHT.install(percent);
                    Texts texts = Texts.of("study", Language.ENGLISH);
                    stage.set(new ChartStage(model, texts, failures::add));
                });
        EventQueue.invokeAndWait(
                () -> {
                    stage.get().setSize(WIDTH, HEIGHT);
                    stage.get().refresh();
                });
        BufferedImage image = OffscreenPainter.paint(stage.get(), WIDTH, HEIGHT);
        EventQueue.invokeAndWait(stage.get()::close);
        int first = 4;
        while (!hasInk(image, first)) first++;
        int end = first;
        while (hasInk(image, end)) end++;
        return end - first;
    }

    private static boolean hasInk(BufferedImage image, int y) {
        for (int x = 4; x < WIDTH - 4; x++) if ((image.getRGB(x, y) & 0xFF) < 128) return true;
        return false;
    }
}
