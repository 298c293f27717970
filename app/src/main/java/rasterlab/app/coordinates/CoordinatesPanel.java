package rasterlab.app.coordinates;

import java.awt.CardLayout;
import java.util.EnumMap;
import java.util.Map;
import java.util.function.Consumer;
import rasterlab.app.canvas.LabPanel;
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
    private final CardLayout cards = new CardLayout();
    private final Map<CoordinatesMode, LabCard> labs = new EnumMap<>(CoordinatesMode.class);
    private final transient Runnable unsubscribe;

    /**
     * @param onFailure told what a control could not do or painting threw, on any thread
     */
    public CoordinatesPanel(
            CoordinatesLabModel model, Language language, Consumer<Throwable> onFailure) {
        this.model = model;
        this.language = language;
        this.onFailure = onFailure;
        setLayout(cards);
        setName("coordinates");
        unsubscribe = model.listen(this::show);
        show(model.mode());
    }

    private LabCard made(CoordinatesMode mode) {
        LabCard card =
                switch (mode) {
                    case TRANSFORMATIONS ->
                            new ListPanel(
                                    model.transformations(), language, this::choose, onFailure);
                    case ROTATION ->
                            new TurnPanel(model.rotation(), language, this::choose, onFailure);
                    case MEETING ->
                            new MeetingPanel(model.meeting(), language, this::choose, onFailure);
                    case STACK -> new StackPanel(model.stack(), language, this::choose, onFailure);
                    case VIEWS -> new ViewPanel(model.views(), language, this::choose, onFailure);
                };
        add(card, mode.code());
        return card;
    }

    /** Gives the keyboard to the picture of the lab that is shown. */
    @Override
    public void focusPicture() {
        labs.get(model.mode()).focusPicture();
    }

    /** Stops listening and playing; the models live on. */
    @Override
    public void close() {
        unsubscribe.run();
        labs.values().forEach(LabCard::close);
    }

    private void choose(CoordinatesMode mode) {
        if (mode == model.mode()) return;
        model.show(mode);
        focusPicture();
    }

    private void show(CoordinatesMode mode) {
        labs.values().forEach(LabCard::stop);
        labs.computeIfAbsent(mode, this::made);
        cards.show(this, mode.code());
        revalidate();
    }
}
