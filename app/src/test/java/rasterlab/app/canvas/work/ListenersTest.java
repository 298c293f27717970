package rasterlab.app.canvas.work;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class ListenersTest {
    private final Listeners<String> listeners = new Listeners<>();
    private final List<String> heard = new ArrayList<>();

    @Test
    void whoHasLeftIsToldNoMore() {
        Runnable leave = listeners.add(heard::add);
        listeners.tell("one");
        leave.run();
        listeners.tell("two");
        assertEquals(List.of("one"), heard);
    }

    @Test
    void whoComesWhileOthersAreToldCountsTheNextTime() {
        listeners.add(news -> listeners.add(heard::add));
        listeners.tell("one");
        assertEquals(List.of(), heard);
        listeners.tell("two");
        assertEquals(List.of("two"), heard);
    }
}
