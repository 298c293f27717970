package rasterlab.app.canvas.lab;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class LabCardsTest {
    private final List<String> events = new ArrayList<>();
    private final LabPanel tab = new Lab("tab");
    private final LabCards<String> cards = new LabCards<>(tab, Lab::new);

    private final class Lab extends LabPanel {
        private static final long serialVersionUID = 1L;

        Lab(String name) {
            setName(name);
            events.add(name + " is made");
        }

        @Override
        public List<Runnable> parts() {
            return List.of(() -> events.add(getName() + " is whole"));
        }

        @Override
        public void refresh() {
            events.add(getName() + " is filled");
        }

        @Override
        public void focusPicture() {
            events.add(getName() + " has the keyboard");
        }

        @Override
        public void stop() {
            events.add(getName() + " stops");
        }

        @Override
        public void close() {
            events.add(getName() + " is closed");
        }
    }

    @Test
    void labIsMadeWhenItIsFirstSeenAndStopsWhenAnotherIs() {
        cards.show("one");
        cards.show("two");
        cards.show("one");
        cards.focusPicture("one");
        assertEquals(
                List.of(
                        "tab is made",
                        "one is made",
                        "one is whole",
                        "one is filled",
                        "one stops",
                        "two is made",
                        "two is whole",
                        "two is filled",
                        "one stops",
                        "two stops",
                        "one has the keyboard"),
                events);
        assertEquals(2, tab.getComponentCount());
    }

    @Test
    void partsOfTheFirstLabAreLeftToWhoBeginsIt() {
        List<Runnable> parts = cards.begin("one");
        assertEquals(List.of("tab is made", "one is made"), events);
        parts.forEach(Runnable::run);
        cards.show("one");
        assertEquals(
                List.of("tab is made", "one is made", "one is whole", "one stops", "one is filled"),
                events);
    }

    @Test
    void onlyWhatWasMadeIsClosed() {
        cards.show("one");
        events.clear();
        cards.close();
        assertEquals(List.of("one is closed"), events);
    }
}
