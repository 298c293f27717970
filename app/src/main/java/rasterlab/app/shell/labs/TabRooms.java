package rasterlab.app.shell.labs;

import java.util.List;
import java.util.stream.Stream;
import rasterlab.app.card.LabRoom;
import rasterlab.app.exercise.panel.ExerciseRoom;
import rasterlab.app.rooms.LabRooms;
import rasterlab.app.study.StudyRoom;

/** The list of every tab: the labs, and behind them those that open the labs' tabs. */
public final class TabRooms {
    private TabRooms() {}

    /** All of them, in the order of the window. */
    public static List<LabRoom<?>> all() {
        return Stream.concat(
                        LabRooms.all().stream(), Stream.of(new StudyRoom(), new ExerciseRoom()))
                .toList();
    }

    /** The one of that name, or the first. */
    public static LabRoom<?> namedOrFirst(String tab) {
        List<LabRoom<?>> all = all();
        return all.stream().filter(each -> each.name().equals(tab)).findFirst().orElse(all.get(0));
    }
}
