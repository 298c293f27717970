package rasterlab.app.line;

import java.awt.CardLayout;
import java.util.function.Consumer;
import rasterlab.app.canvas.LabPanel;
import rasterlab.app.language.Language;

/** The lab of lines as the window shows it, in one language: segments or other figures. */
public final class LinePanel extends LabPanel {
    private static final long serialVersionUID = 1L;

    private static final String SEGMENT = "segment";
    private static final String FIGURE = "figure";

    private final transient LineLabModel model;
    private final CardLayout cards = new CardLayout();
    private final SegmentPanel segment;
    private final FigurePanel figure;
    private final transient Runnable unsubscribe;

    /**
     * @param onFailure told what a control could not do or painting threw, on any thread
     */
    public LinePanel(LineLabModel model, Language language, Consumer<Throwable> onFailure) {
        this.model = model;
        setLayout(cards);
        setName("line");
        segment = new SegmentPanel(model, language, onFailure);
        figure = new FigurePanel(model, language, onFailure);
        add(segment, SEGMENT);
        add(figure, FIGURE);
        unsubscribe =
                model.listenToMode(
                        mode -> {
                            show(mode);
                            focusPicture();
                        });
        show(model.mode());
    }

    /** Gives the keyboard to the point that had it last. */
    @Override
    public void focusPicture() {
        if (model.mode() == LineMode.SEGMENT) segment.focusPicture();
        else figure.focusPicture();
    }

    /** Stops listening and playing; the models live on. */
    @Override
    public void close() {
        unsubscribe.run();
        segment.close();
        figure.close();
    }

    private void show(LineMode mode) {
        segment.stop();
        figure.stop();
        cards.show(this, mode == LineMode.SEGMENT ? SEGMENT : FIGURE);
    }
}
