package rasterlab.app.coordinates;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import rasterlab.app.canvas.lab.LabCards;
import rasterlab.app.canvas.lab.LabPanel;
import rasterlab.app.canvas.widget.NameChooser;
import rasterlab.app.coordinates.figure.CoordinatesMode;
import rasterlab.app.coordinates.figure.LabCard;
import rasterlab.app.coordinates.list.ListPanel;
import rasterlab.app.coordinates.meeting.MeetingPanel;
import rasterlab.app.coordinates.stack.StackPanel;
import rasterlab.app.coordinates.turn.TurnPanel;
import rasterlab.app.coordinates.view.ViewPanel;
import rasterlab.app.language.Language;

/** The labs of coordinates as the window shows them, in one language; each made when first seen. */
public final class CoordinatesPanel extends LabPanel {
    private static final long serialVersionUID = 1L;

    private final transient CoordinatesLabModel model;
    private final Language language;
    private final transient Consumer<Throwable> onFailure;
    private final transient LabCards<CoordinatesMode> cards;
    private transient Runnable unsubscribe = () -> {};

    /**
     * @param onFailure told what a control could not do or painting threw, on any thread
     */
    public CoordinatesPanel(
            CoordinatesLabModel model, Language language, Consumer<Throwable> onFailure) {
        this.model = model;
        this.language = language;
        this.onFailure = onFailure;
        setName("coordinates");
        cards = new LabCards<>(this, this::made);
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

    private LabCard made(CoordinatesMode mode) {
        return switch (mode) {
            case TRANSFORMATIONS ->
                    new ListPanel(model.transformations(), language, this::choose, onFailure);
            case ROTATION -> new TurnPanel(model.rotation(), language, this::choose, onFailure);
            case MEETING -> new MeetingPanel(model.meeting(), language, this::choose, onFailure);
            case STACK -> new StackPanel(model.stack(), language, this::choose, onFailure);
            case VIEWS -> new ViewPanel(model.views(), language, this::choose, onFailure);
        };
    }

    /** Gives the keyboard to the picture of the lab that is shown. */
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

    private void choose(CoordinatesMode mode) {
        if (mode == model.mode()) return;
        boolean byKeys = NameChooser.byKeys();
        model.show(mode);
        if (!byKeys) focusPicture();
    }
}
