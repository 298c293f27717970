package rasterlab.app.rooms;

import java.util.List;
import java.util.stream.Stream;
import rasterlab.app.card.LabRoom;
import rasterlab.app.card.TopicCard;
import rasterlab.app.clip.ClipRoom;
import rasterlab.app.coordinates.CoordinatesRoom;
import rasterlab.app.light.panel.LightRoom;
import rasterlab.app.line.LineRoom;
import rasterlab.app.opengl.OpenGlRoom;
import rasterlab.app.polygon.PolygonRoom;
import rasterlab.app.spline.SplineRoom;
import rasterlab.app.visibility.VisibilityRoom;
import rasterlab.engine.naming.Named;

/** The list of every lab that needs no other; a further lab is one more line. */
public final class LabRooms {
    private LabRooms() {}

    /** All of them, in the order of their tabs. */
    public static List<LabRoom<?>> all() {
        return List.of(
                new CoordinatesRoom(),
                new LineRoom(),
                new PolygonRoom(),
                new ClipRoom(),
                new VisibilityRoom(),
                new LightRoom(),
                new SplineRoom(),
                new OpenGlRoom());
    }

    /** The cards of all topics, in the order of the tabs that show them. */
    public static List<TopicCard<?>> cards() {
        return Cards.ALL;
    }

    private static <M> Stream<TopicCard<M>> cards(LabRoom<M> room) {
        return room.cards().stream();
    }

    /**
     * The card of that topic.
     *
     * @throws IllegalArgumentException if no lab shows it; lists the topics that labs show
     */
    public static TopicCard<?> card(String topic) {
        return Named.find("topic with a card", topic, Cards.ALL, TopicCard::topic);
    }

    /** The cards, made once, when the first is asked for: labs and cards hold no state. */
    private static final class Cards {
        static final List<TopicCard<?>> ALL =
                all().stream().<TopicCard<?>>flatMap(LabRooms::cards).toList();
    }
}
