package rasterlab.app.card;

import java.util.List;
import java.util.function.Consumer;
import rasterlab.app.canvas.lab.Chips;
import rasterlab.app.canvas.lab.HazardCase;
import rasterlab.app.language.Texts;
import rasterlab.engine.study.Hazard;

/** The hazards of a topic above the stage of the lab that shows it. */
public final class TopicChips {
    private TopicChips() {}

    /**
     * A chip for each hazard, in the topic's words.
     *
     * @param texts the lab's
     * @param topic whose hazards they are
     * @param methods names of those that the lab offers
     * @param chosen shows the hazard's input
     */
    public static <H extends Hazard<?>> Chips of(
            Texts texts, String topic, List<H> hazards, List<String> methods, Consumer<H> chosen) {
        var chips = new Chips(texts, "hazards").of(topic);
        TopicTexts said = TopicTexts.of(topic, texts.language());
        for (H each : hazards)
            chips.add(
                    HazardCase.of(
                            each,
                            said.title(each),
                            said.hazard(each),
                            methods,
                            () -> chosen.accept(each)));
        return chips;
    }
}
