package rasterlab.app.rooms;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.app.card.TopicCard;
import rasterlab.engine.Topics;
import rasterlab.engine.study.Topic;

class LabRoomsTest {
    @Test
    @DisplayName("a topic has no card or two, or a card no topic")
    void everyTopicHasOneCard() {
        assertEquals(
                Topics.all().stream().map(Topic::name).sorted().toList(),
                LabRooms.cards().stream().map(TopicCard::topic).sorted().toList());
    }

    @Test
    void unknownTopicIsToldWithThoseThereAre() {
        var refused = assertThrows(IllegalArgumentException.class, () -> LabRooms.card("nothing"));
        for (String told : List.of("'nothing'", "line", "texture-filter"))
            assertTrue(refused.getMessage().contains(told), refused.getMessage());
    }
}
