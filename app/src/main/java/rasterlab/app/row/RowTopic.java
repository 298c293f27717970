package rasterlab.app.row;

import java.util.function.Function;
import rasterlab.app.card.LabRoom;
import rasterlab.app.card.TopicBinding;
import rasterlab.app.card.TopicCard;

/** Makes the card of a topic whose inputs are shown as rows, in whichever tab the rows stand. */
public final class RowTopic {
    private RowTopic() {}

    /**
     * @param lab of the tab
     * @param rows of the tab's model
     */
    public static <M> TopicCard<M> card(
            LabRoom<M> lab, String topic, Function<M, RowLabModel> rows) {
        return new TopicCard<>(topic, lab, RowColors.OWN, way(topic, rows));
    }

    private static <M> TopicBinding<M> way(String topic, Function<M, RowLabModel> rows) {
        return TopicBinding.<M>whole(
                        (lab, input, method) -> {
                            if (input.hazard().isEmpty())
                                rows.apply(lab).show(topic, input.input(), method);
                            else rows.apply(lab).show(topic, input.hazard(), method);
                        })
                .writing(lab -> rows.apply(lab).input(topic))
                .withOwn(
                        lab -> rows.apply(lab).history(),
                        lab -> rows.apply(lab).openAgain(topic),
                        (lab, method) -> rows.apply(lab).chooseMethod(method),
                        (lab, method) -> {});
    }
}
