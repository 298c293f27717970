package rasterlab.app.rooms;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Set;
import java.util.TreeMap;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.app.card.LabRoom;
import rasterlab.app.card.LabShot;
import rasterlab.app.card.TopicCard;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
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

    @Test
    @DisplayName("two pictures of the tour have one name, or one has no caption")
    void everyShotHasItsNameAndCaption() {
        var captions = new TreeMap<String, String>();
        for (LabRoom<?> room : LabRooms.all()) {
            Texts texts = Texts.of(room.name(), Language.ENGLISH);
            for (LabShot<?> shot : room.shots())
                assertNull(captions.put(shot.name(), texts.text("tour." + shot.name())));
        }
        assertEquals(captions.size(), Set.copyOf(captions.values()).size());
    }
}
