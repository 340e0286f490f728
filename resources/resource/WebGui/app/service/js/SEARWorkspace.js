// The workspace of the SEAR panel: how it fills the window, and which of its parts are folded.
(function() {
    var geometry = window.SEARPanel.geometry
    var FOLDS = 'sear.folds'    // where the browser remembers what its user has folded and opened
    var WIDE = 1100             // pixels from which on there are three columns
    var MEDIUM = 720            // and two; below, all stands below each other, and the page scrolls
    var SLACK = 24              // more than a scroll bar that comes or goes
    var LEAST = 480             // pixels of height that the columns need
    var MOST_BELOW = 200        // pixels that are kept free for what the page has below the panel
    var TALL = 800              // pixels of a window in which messages and scripts are open at first

    /** Where an element begins in the page, wherever that is scrolled to. */
    function topOf(element) {
        var top = 0
        for (var e = element; e; e = e.offsetParent) {
            top += e.offsetTop
        }
        return top
    }

    /** What an element scrolls in: MyRobotLab's own frame around panels, or the page. */
    function frameOf(element) {
        var e = element.parentElement
        while (e !== document.body && !/auto|scroll/.test(window.getComputedStyle(e).overflowY)) {
            e = e.parentElement
        }
        return e
    }

    /** Pixels of what a frame has below an element. */
    function below(element, frame) {
        var sum = 0
        for (var e = element; e !== frame; e = e.parentElement) {
            var bottom = e.getBoundingClientRect().bottom
            var style = window.getComputedStyle(e.parentElement)
            sum += parseFloat(style.paddingBottom) + parseFloat(style.borderBottomWidth) + parseFloat(style.marginBottom)
            for (var next = e.nextElementSibling; next; next = next.nextElementSibling) {
                var box = next.getBoundingClientRect()
                sum += box.top >= bottom - 1 ? box.height : 0
            }
        }
        return Math.min(MOST_BELOW, Math.ceil(sum))
    }

    /** Pixels from where an element begins to where its frame, or the window, ends, without what stands below it. */
    function roomFor(element) {
        var frame = frameOf(element)
        var end = frame === document.body ? window.innerHeight : Math.min(window.innerHeight, topOf(frame) + frame.clientHeight)
        return end - topOf(element) - below(element, frame)
    }

    /** Adds it to a panel. */
    window.SEARPanel.workspace = function(panel) {
        var $scope = panel.scope
        var chosen = remembered()   // by the name of a part: whether its user has folded it
        $scope.room = roomOf(window.innerWidth)     // 'wide', 'medium' or 'narrow'

        function remembered() {
            try {
                var folds = angular.fromJson(window.localStorage.getItem(FOLDS))
                return angular.isObject(folds) ? folds : {}
            } catch (e) {
                return {}
            }
        }
        /** As long as nobody has chosen. */
        function isFoldedAtFirst(part) {
            var narrow = $scope.room === 'narrow'
            switch (part) {
            case 'plots': return true
            case 'messages': return !narrow && window.innerHeight < TALL
            case 'scripts': return !narrow && window.innerHeight < TALL
            case 'project': return narrow
            case 'world': return narrow
            default: return false
            }
        }
        /** Only a narrow page folds the project away. */
        $scope.isFolded = function(part) {
            return part === 'project' && $scope.room !== 'narrow' ? false : part in chosen ? Boolean(chosen[part]) : isFoldedAtFirst(part)
        }
        /** Folds a part, or opens it. */
        $scope.fold = function(part) {
            chosen[part] = !$scope.isFolded(part)
            try {
                window.localStorage.setItem(FOLDS, angular.toJson(chosen))
            } catch (e) {
                panel.say('warn', 'this browser does not remember what is folded: ' + e.message)
            }
        }

        function roomOf(width) {
            var room = $scope.room
            return width >= WIDE + (room === 'wide' ? 0 : SLACK) ? 'wide' : width >= MEDIUM + (room === 'narrow' ? SLACK : 0) ? 'medium' : 'narrow'
        }
        /** Takes the room and the height that there are now; those of before while the tab is not shown. @return them */
        function measure() {
            var whole = $scope.service && document.getElementById('sear-workspace-' + $scope.service.name)
            if (!whole || !whole.clientWidth) {
                return ''
            }
            $scope.room = roomOf(whole.clientWidth)
            var height = $scope.room === 'narrow' ? '' : Math.max(LEAST, roomFor(whole)) + 'px'
            if (whole.style.height !== height) {
                whole.style.height = height
            }
            $scope.dark = geometry.isLight(window.getComputedStyle(whole).color)    // a page may be light where its user prefers dark ones
            return $scope.room + ' ' + height + ' ' + $scope.dark
        }
        $scope.$watch(measure)
    }
})()
