package rasterlab.app.spline;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import rasterlab.app.canvas.lab.LabCards;
import rasterlab.app.canvas.lab.LabPanel;
import rasterlab.app.canvas.widget.NameChooser;
import rasterlab.app.language.Language;

/** The lab of splines as the window shows it, in one language: curves or functions. */
public final class SplinePanel extends LabPanel {
    private static final long serialVersionUID = 1L;

    private final transient SplineLabModel model;
    private final transient LabCards<SplineMode> cards;
    private transient Runnable unsubscribe = () -> {};

    /**
     * @param onFailure told what a control could not do or painting threw, on any thread
     */
    public SplinePanel(SplineLabModel model, Language language, Consumer<Throwable> onFailure) {
        this.model = model;
        setName("spline");
        cards =
                new LabCards<>(
                        this,
                        mode ->
                                switch (mode) {
                                    case CURVE ->
                                            new CurvePanel(
                                                    model.curve(),
                                                    language,
                                                    this::choose,
                                                    onFailure);
                                    case FUNCTION ->
                                            new FunctionPanel(
                                                    model.function(),
                                                    language,
                                                    this::choose,
                                                    onFailure);
                                });
    }

    @Override
    public List<Runnable> parts() {
        var parts = new ArrayList<>(cards.begin(model.mode()));
        parts.add(() -> unsubscribe = model.listen(cards::show));
        return parts;
    }

    @Override
    public void refresh() {
        cards.show(model.mode());
    }

    /** Gives the keyboard to the point that had it last. */
    @Override
    public void focusPicture() {
        cards.focusPicture(model.mode());
    }

    /** Stops listening and playing; the models live on. */
    @Override
    public void close() {
        unsubscribe.run();
        cards.close();
    }

    private void choose(SplineMode mode) {
        if (mode == model.mode()) return;
        boolean byKeys = NameChooser.byKeys();
        model.show(mode);
        if (!byKeys) focusPicture();
    }
}
