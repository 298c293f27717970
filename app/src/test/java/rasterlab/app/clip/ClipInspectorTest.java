package rasterlab.app.clip;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.EventQueue;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import javax.swing.JScrollPane;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import rasterlab.app.canvas.work.ModelThread;
import rasterlab.app.clip.outcome.ClipTopics;
import rasterlab.app.clip.scene.ClipMode;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;

@Timeout(300)
class ClipInspectorTest {
    private final ModelThread thread = new ModelThread();
    private final List<Throwable> failures = new CopyOnWriteArrayList<>();
    private final ClipLabModel model = new ClipLabModel(new ClipTopics(), thread, failures::add);

    @AfterEach
    void close() {
        model.close();
        assertEquals(List.of(), failures);
    }

    @Test
    @DisplayName("new numbers in the matrices scroll the inspector to them")
    void numbersDoNotScroll() throws Exception {
        var inspector = new ClipInspector(model, Texts.of("clip", Language.ENGLISH));
        inspector.sections().forEach(Runnable::run);
        var scroll = new JScrollPane(inspector.column());
        model.chooseMode(ClipMode.VOLUME);
        thread.settle(model::settle);
        for (int i = 0; i < 2; i++) {
            EventQueue.invokeAndWait(
                    () -> {
                        inspector.refresh();
                        scroll.setSize(400, 300);
                        scroll.doLayout();
                        scroll.getViewport().doLayout();
                        inspector.column().doLayout();
                    });
            EventQueue.invokeAndWait(() -> {});
        }
        assertEquals(0, scroll.getViewport().getViewPosition().y);
    }
}
