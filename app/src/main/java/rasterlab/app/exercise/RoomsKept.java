package rasterlab.app.exercise;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;

/** How a window's {@link Rooms} were left, for those in another language or theme. */
final class RoomsKept {
    private final Map<String, Double> shares = new HashMap<>();
    private Optional<Rooms.Room> chosen = Optional.empty();

    /** Of the room before the divider of that name, from 0 to 1. */
    double share(String divider, double usual) {
        return shares.getOrDefault(divider, usual);
    }

    void divide(String divider, double share) {
        shares.put(divider, share);
    }

    /** The part that was in sight last; empty before any was. */
    Optional<Rooms.Room> chosen() {
        return chosen;
    }

    void choose(Rooms.Room room) {
        chosen = Optional.of(room);
    }
}
