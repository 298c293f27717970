package rasterlab.app.spline;

import java.awt.CardLayout;
import java.util.function.Consumer;
import rasterlab.app.canvas.LabPanel;
import rasterlab.app.language.Language;

/** The lab of splines as the window shows it, in one language: curves or functions. */
public final class SplinePanel extends LabPanel {
    private static final long serialVersionUID = 1L;

    private final transient SplineLabModel model;
    private final CardLayout cards = new CardLayout();
    private final CurvePanel curve;
    private final FunctionPanel function;
    private final transient Runnable unsubscribe;

    /**
     * @param onFailure told what a control could not do or painting threw, on any thread
     */
    public SplinePanel(SplineLabModel model, Language language, Consumer<Throwable> onFailure) {
        this.model = model;
        setLayout(cards);
        setName("spline");
        curve = new CurvePanel(model.curve(), language, this::choose, onFailure);
        function = new FunctionPanel(model.function(), language, this::choose, onFailure);
        add(curve, SplineMode.CURVE.code());
        add(function, SplineMode.FUNCTION.code());
        unsubscribe = model.listen(this::show);
        show(model.mode());
    }

    /** Gives the keyboard to the point that had it last. */
    @Override
    public void focusPicture() {
        if (model.mode() == SplineMode.CURVE) curve.focusPicture();
        else function.focusPicture();
    }

    /** Stops listening and playing; the models live on. */
    @Override
    public void close() {
        unsubscribe.run();
        curve.close();
        function.close();
    }

    private void choose(SplineMode mode) {
        if (mode == model.mode()) return;
        model.show(mode);
        focusPicture();
    }

    private void show(SplineMode mode) {
        curve.stop();
        function.stop();
        cards.show(this, mode.code());
    }
}
