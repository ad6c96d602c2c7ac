// Whether a driver has ended a loop that was to go on. A loop that is cut is open behind its end: ts_turn takes what says
// whether there is one more turn, and each turn ends by opening the loop.
bool ts_open = false;
bool ts_cut = false;
bool ts_turn(bool more)
{
	ts_open = more;
	return more;
}
void ts_looped() { ts_cut = ts_cut || ts_open; }
