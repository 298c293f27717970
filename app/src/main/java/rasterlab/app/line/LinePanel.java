package rasterlab.app.line;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import rasterlab.app.canvas.lab.LabCards;
import rasterlab.app.canvas.lab.LabPanel;
import rasterlab.app.canvas.widget.NameChooser;
import rasterlab.app.language.Language;
import rasterlab.app.line.trace.LineMode;

/** The lab of lines as the window shows it, in one language: segments or other figures. */
public final class LinePanel extends LabPanel {
    private static final long serialVersionUID = 1L;

    private final transient LineLabModel model;
    private final transient LabCards<Card> cards;
    private transient Runnable unsubscribe = () -> {};

    private enum Card {
        SEGMENT,
        FIGURE;

        static Card of(LineMode mode) {
            return mode == LineMode.SEGMENT ? SEGMENT : FIGURE;
        }
    }

    /**
     * @param onFailure told what a control could not do or painting threw, on any thread
     */
    public LinePanel(LineLabModel model, Language language, Consumer<Throwable> onFailure) {
        this.model = model;
        setName("line");
        cards =
                new LabCards<>(
                        this,
                        card ->
                                card == Card.SEGMENT
                                        ? new SegmentPanel(model, language, onFailure)
                                        : new FigurePanel(model, language, onFailure));
    }

    @Override
    public List<Runnable> parts() {
        var parts = new ArrayList<>(cards.begin(Card.of(model.mode())));
        parts.add(this::listen);
        return parts;
    }

    private void listen() {
        unsubscribe =
                model.listenToMode(
                        mode -> {
                            boolean byKeys = NameChooser.byKeys();
                            cards.show(Card.of(mode));
                            if (!byKeys) focusPicture();
                        });
    }

    @Override
    public void refresh() {
        cards.show(Card.of(model.mode()));
    }

    /** Gives the keyboard to the point that had it last. */
    @Override
    public void focusPicture() {
        cards.focusPicture(Card.of(model.mode()));
    }

    /** Stops listening and playing; the models live on. */
    @Override
    public void close() {
        unsubscribe.run();
        cards.close();
    }
}
